#pragma once

#include "core/asset/bake/Bake.h"
#include "core/asset/project/Variants.h"

#include <map>
#include <memory>
#include <span>

namespace rubble {

/// Bakes by asset and variant.
using AssetBakes = std::map<AssetVariant, std::shared_ptr<const Bake>>;

/// Bakes the assets in `only`, or all assets if it is empty, each in all variants that the project uses. Runs on
/// task.threads.
///
/// Errors: those of bake(), of the first asset that has one; Limit if all would be too large together
/// (totalSizeFault()), before they start.
Result<AssetBakes> bakesOf(const Project& project, std::span<const Id> only = {}, const TaskContext& task = {});

}  // namespace rubble
