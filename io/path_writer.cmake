target_sources(proveout_io PRIVATE path_writer.cpp)
