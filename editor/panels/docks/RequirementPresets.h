#pragma once

#include "core/asset/project/Project.h"

#include <QString>

#include <vector>

namespace rubble {

using RequirementEvent = decltype(StrengthRequirement::event);

/// A common event that an asset may have to survive or break in.
struct RequirementPreset {
    QString name;  // with a mnemonic, for menus: "&Thrown Stone"
    RequirementEvent event;
};

/// Common events, the weakest first.
std::vector<RequirementPreset> requirementPresets();

/// How the computed impulse assumes that the event happens, in a few words: "square on the centre, free to move".
QString assumptionText(const RequirementEvent& event, bool isFixed);
/// The same at length, for a tooltip.
QString assumptionDescription(const RequirementEvent& event, bool isFixed);

/// The name of the shot that plays an event: "0.43 kg at 20 m/s".
QString shotNameOf(const RequirementEvent& event);

}  // namespace rubble
