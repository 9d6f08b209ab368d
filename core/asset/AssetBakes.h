#pragma once

#include "core/asset/Bake.h"

#include <map>
#include <span>

namespace rubble {

/// Bakes by asset.
using AssetBakes = std::map<Id, std::shared_ptr<const Bake>>;

/// Bakes the assets of a project that are named, or all of them where `only` is empty; several at a time on task.threads.
///
/// Errors: those of bake(), of the first asset that has one.
Result<AssetBakes> bakesOf(const Project& project, std::span<const Id> only = {}, const TaskContext& task = {});

}  // namespace rubble
