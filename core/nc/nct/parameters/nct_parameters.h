// The parameters of the nct control, by the manual's numbers.
#pragma once

#include <map>
#include <string>

#include "core/nc/iso/parameters/parameter_table.h"

namespace proveout::nc {

const ParameterTable& nctParameters();
/// All rows, for the job reader.
std::vector<ParameterInfo> nctParameterList();
/// Whether values by name, as jobs give them, have an end of the stroke of an axis: "N1002", "N1003.2".
bool givesStroke(const std::map<std::string, double>& values);

}  // namespace proveout::nc
