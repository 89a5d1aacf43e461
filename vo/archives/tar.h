#pragma once

#include <string>

#include "vo/files/output.h"

namespace vo {

/// Returns a file as an entry of a tar archive in the format ustar (POSIX.1-2017, pax, "ustar
/// Interchange Format"), without owner and time, so that equal files give equal archives. An
/// archive is its entries one after the other and `tar_end`. Throws Error for a name of more than
/// 100 bytes and for a file of 8 GiB or more, which the format cannot hold.
std::string tar_entry(const NamedBytes& file);

/// Returns what ends a tar archive.
std::string tar_end();

}  // namespace vo
