#pragma once

#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The most bytes of a safe name: so many leave room for endings in all file systems.
inline constexpr std::size_t kLongestName = 200;
/// So many leave room in the names of objects in Blender, of 63 bytes, and in paths of Windows, of 260 characters.
inline constexpr std::size_t kShortestName = 32;

/// Returns `name` as a name of a file or folder that is valid on Linux, macOS and Windows, also before an ending. In it
/// are letters, digits, marks and symbols of all scripts, of ASCII only letters, digits, '-', '_', '.' and ' '; every
/// other character becomes '_', as does a '.' or ' ' at either end, and a '-' at the start, which programs take for an
/// option. A device of Windows, such as "con" or "aux.x", gets a '_' in front. Never empty; in normalization form C.
/// One of more than `most` bytes, from kShortestName to kLongestName, is shortened and gets a hash of the whole.
/// docs/formats/names.md has the rules with their sources.
std::string safeFileName(const std::string& name, std::size_t most = kLongestName);

/// Returns the file names of several names, which no file system takes for one another: the safeFileName() of each, or
/// that and a number from 2 on where it is taken, as by the first of "Wall" and "wall".
std::vector<std::string> distinctFileNames(std::span<const std::string> names, std::size_t most = kLongestName);

/// Returns `start`, `name` and `end` as one file name. One of more than 255 bytes, the limit of Linux file systems,
/// gets a shortened name with a hash of the whole.
std::string fittingFileName(const std::string& start, const std::string& name, const std::string& end);

}  // namespace rubble
