#include "editor/panels/docks/RequirementPresets.h"

#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCoreApplication>

namespace rubble {

namespace {

struct PresetText {
    Q_DECLARE_TR_FUNCTIONS(RequirementPresets)
};

}  // namespace

std::vector<RequirementPreset> requirementPresets() {
    return {{PresetText::tr("&Pushed by Hand (0.5 kg at 1 m/s)"), HitRequirement{.mass = 0.5, .speed = 1.0}},
            {PresetText::tr("Thrown &Stone (50 g at 20 m/s)"), HitRequirement{.mass = 0.05, .speed = 20.0}},
            {PresetText::tr("&Football at 20 m/s (0.43 kg)"), HitRequirement{.mass = 0.43, .speed = 20.0}},
            {PresetText::tr("S&ledgehammer (5 kg at 10 m/s)"), HitRequirement{.mass = 5.0, .speed = 10.0}},
            {PresetText::tr("&Car at 50 km/h (1.2 t)"), HitRequirement{.mass = 1200.0, .speed = 13.9}},
            {PresetText::tr("&Dropped from 1 m"), DropRequirement{.height = 1.0}},
            {PresetText::tr("D&ropped from 3 m"), DropRequirement{.height = 3.0}},
            {PresetText::tr("&Impulse of 10 N·s"), ImpulseRequirement{.impulse = 10.0}}};
}

QString assumptionText(const RequirementEvent& event, bool isFixed) {
    if (std::holds_alternative<DropRequirement>(event)) return PresetText::tr("upright, onto level ground");
    if (std::holds_alternative<ImpulseRequirement>(event)) return PresetText::tr("wherever it hits");
    return isFixed ? PresetText::tr("square hit on the centre, held in place")
                   : PresetText::tr("square hit on the centre, free to move");
}

QString assumptionDescription(const RequirementEvent& event, bool isFixed) {
    if (std::holds_alternative<DropRequirement>(event)) {
        return PresetText::tr(
            "The asset falls in its own orientation onto level ground. Tilted, it lands on an edge or a "
            "corner, which takes less");
    }
    if (std::holds_alternative<ImpulseRequirement>(event)) {
        return PresetText::tr("The impulse on the intact asset, as the list of impacts shows it");
    }
    if (isFixed) {
        return PresetText::tr(
            "The flat face of a small cube hits the centre of the front at right angles. The asset is "
            "held in place, as its fixed instances are, so that it takes the whole impulse anywhere. "
            "Oblique hits do less");
    }
    return PresetText::tr(
        "The flat face of a small cube hits the centre of the front at right angles. The asset is free "
        "to move, so that it gives way: off-centre and oblique hits do less");
}

QString shotNameOf(const RequirementEvent& event) {
    if (const auto* drop = std::get_if<DropRequirement>(&event)) {
        return PresetText::tr("drop of %1").arg(localizedQuantity(QuantityKind::Length, drop->height));
    }
    if (const auto* impact = std::get_if<ImpulseRequirement>(&event)) {
        return PresetText::tr("blow of %1").arg(localizedQuantity(QuantityKind::Impulse, impact->impulse));
    }
    const auto& hit = std::get<HitRequirement>(event);
    return PresetText::tr("%1 at %2")
        .arg(localizedQuantity(QuantityKind::Mass, hit.mass), localizedQuantity(QuantityKind::Speed, hit.speed));
}

}  // namespace rubble
