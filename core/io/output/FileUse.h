#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// What a run does with a file.
enum class FileRole {
    Read,
    Changed,  // read, and written in its place
    Written,  // as a whole, whatever was there
};

/// A file that a run uses.
struct FileUse {
    std::filesystem::path path;
    FileRole role = FileRole::Read;
    std::string name;                     // in messages, of what is written: "--out", "the video"
    std::vector<std::string> extensions;  // of what is written: an existing file has one of them; empty: any
    std::string what;                     // in messages, what another file is: "the project"; empty: that it is read
};

/// Whether files can be written without harm to others, before anything is written. Links are followed, and files told
/// apart by device and inode; pipes and devices may be written to. Refused is a file
/// - that the run also reads, changes, or writes otherwise;
/// - that is one of an export, by the index and the manifests beside it;
/// - that lies in the folder of a project's meshes;
/// - that exists with an extension that what is written does not have: it is something else.
///
/// Errors: BadInput, with the path and what to do.
Status checkFileUses(std::span<const FileUse> uses);

}  // namespace rubble
