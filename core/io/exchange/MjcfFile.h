#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/exchange/PackBuilder.h"

#include <cstdint>
#include <span>
#include <string>

namespace rubble {

/// Returns fragments of a pack as a model of MuJoCo (MJCF): free bodies at their offsets, with mass, inertia and hulls,
/// on a floor below the asset, and the options that docs/engines.md advises. `fragments`: ascending, none nested in
/// another. Bonds are not written. See docs/formats/usd-mjcf.md.
///
/// Errors: Cancelled.
Result<std::string> mjcfFile(const PackBuilder& pack, std::span<const std::uint32_t> fragments,
                             const TaskContext& task = {});

}  // namespace rubble
