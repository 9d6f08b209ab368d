#include "core/io/system/ProgramFolder.h"

#ifdef __linux__
#include <sys/auxv.h>
#endif

#include <bit>
#include <system_error>

namespace rubble {

std::filesystem::path programFolder() {
    std::filesystem::path startedAs;
#ifdef __linux__
    if (const unsigned long name = ::getauxval(AT_EXECFN); name != 0) startedAs = std::bit_cast<const char*>(name);
#endif
    return folderOfProgram("/proc/self/exe", startedAs);
}

std::filesystem::path folderOfProgram(const std::filesystem::path& link, const std::filesystem::path& startedAs) {
    std::error_code error;
    const std::filesystem::path linked = std::filesystem::read_symlink(link, error);
    if (!error && linked.is_absolute()) return linked.parent_path();
    const std::filesystem::path resolved = std::filesystem::canonical(startedAs, error);
    return error ? std::filesystem::path() : resolved.parent_path();
}

}  // namespace rubble
