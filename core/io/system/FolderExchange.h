#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/system/Temporary.h"

#include <filesystem>

namespace rubble {

/// Locks a folder against other processes that replace folders in it, where the file system has locks, until the result
/// is closed. Waits for them. Errors: NotFound; Io; Cancelled.
Result<OpenFile> lockFolder(const std::filesystem::path& folder, const TaskContext& task = {});

/// Gives a new folder its name in one step that survives a power cut; afterwards `replacement` holds the old one, if
/// there was one. Where the file system cannot exchange folders, in two steps. Errors: Io; the old folder is in its
/// place again then. Where that fails, too, the new one is, or the old one lies beside as a leftover that the next
/// export moves back.
Status replaceFolder(const TemporaryFolder& replacement, const std::filesystem::path& folder);

}  // namespace rubble
