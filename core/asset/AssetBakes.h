#pragma once

#include "core/asset/Bake.h"
#include "core/asset/Variants.h"

#include <map>
#include <span>

namespace rubble {

/// Bakes by asset and variant.
using AssetBakes = std::map<AssetVariant, std::shared_ptr<const Bake>>;

/// Bakes the assets of a project that are named, or all of them where `only` is empty, each in all variants that the project
/// uses; several at a time on task.threads.
///
/// Errors: those of bake(), of the first asset that has one.
Result<AssetBakes> bakesOf(const Project& project, std::span<const Id> only = {}, const TaskContext& task = {});

}  // namespace rubble
