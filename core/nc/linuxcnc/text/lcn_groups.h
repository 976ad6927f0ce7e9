// Modal groups: of the codes of one group a line may have one.
#pragma once

namespace proveout::nc {

/// Group of G code `code10` (tenfold); -1: not a code of LinuxCNC.
int lcnGroupOfG(int code10);
/// Group of M code `code`, 0 to 31; -1: none.
int lcnGroupOfM(int code);

}  // namespace proveout::nc
