// Touches of the stock and of fixtures as findings: what one mistake did is one finding.
#pragma once

#include <vector>

#include "app/session/programs/interpretation.h"
#include "io/report.h"
#include "removal/grid/stock.h"

namespace proveout {

/// Contacts less deep than `least_mm` are left out, and those that belong together are one finding, with its
/// deepest place and the first and the last block: of one kind and tool, from blocks that follow each other,
/// from one call of a cycle, or beside each other in space.
/// A spindle of which the program says nothing is the operator's: one warning, not an error, but for threads.
/// Of others it is told since when they stand.
void addContacts(const std::vector<Contact>& contacts, double least_mm, const Toolpath& path,
                 const RecordingSource& texts, std::vector<Finding>& findings);
/// The same with a fixture.
void addFixtureContacts(const std::vector<Contact>& contacts, const std::string& fixture, double least_mm,
                        const Toolpath& path, const RecordingSource& texts, std::vector<Finding>& findings);

}  // namespace proveout
