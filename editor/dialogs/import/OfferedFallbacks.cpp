#include "editor/dialogs/import/OfferedFallbacks.h"

#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCoreApplication>

#include <algorithm>

namespace rubble {

namespace {

struct OfferedFallbackTexts {
    Q_DECLARE_TR_FUNCTIONS(rubble::ImportDialog)
};

}  // namespace

std::vector<OfferedFallback> offeredFallbacks(const std::vector<RejectedObject>& all) {
    std::vector<OfferedFallback> offered;
    for (const RejectedObject& rejected : all) {
        for (const WorkingFallback& working : rejected.fallbacks) {
            auto known = std::ranges::find(offered, working, &OfferedFallback::fallback);
            if (known == offered.end()) known = offered.insert(known, {.fallback = working});
            ++known->objects;
            if (!rejected.volume) continue;
            known->before += *rejected.volume;
            known->after += working.volume;
        }
    }
    return offered;
}

QString fallbackText(const WorkingFallback& working, PrismAxis selected) {
    const bool isSilhouette = working.fallback == PrismFallback::Silhouette;
    if (working.axis == selected)
        return isSilhouette ? OfferedFallbackTexts::tr("Use Silhouette") : OfferedFallbackTexts::tr("Use Top Face");
    const QString axis = QStringLiteral("XYZ").at(static_cast<int>(working.axis) - static_cast<int>(PrismAxis::X));
    return (isSilhouette ? OfferedFallbackTexts::tr("Use Silhouette Along %1")
                         : OfferedFallbackTexts::tr("Use Top Face Along %1"))
        .arg(axis);
}

QString fallbackToolTip(const OfferedFallback& offered, const Units& units) {
    const auto text = [&](double volume) { return localizedQuantity(QuantityKind::Volume, volume, units); };
    const QString count =
        OfferedFallbackTexts::tr("Import %Ln refused object(s) in this way", nullptr, offered.objects);
    if (text(offered.before) == text(offered.after) || !(offered.before > 0.0)) return count;
    return OfferedFallbackTexts::tr("%1; the volume changes from %2 to %3")
        .arg(count, text(offered.before), text(offered.after));
}

}  // namespace rubble
