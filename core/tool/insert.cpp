#include "core/tool/insert.h"
