#include "editor/play/EventFilter.h"

#include <algorithm>

namespace rubble {

bool EventFilter::accepts(const PlayEvent& event) const {
    if (!kinds[static_cast<std::size_t>(event.record.kind)]) return false;
    if (leastEnergy > 0.0 && (!event.hasEnergy() || event.record.energy < leastEnergy)) return false;
    if (material != 0 && std::ranges::find(event.record.materials, material) == event.record.materials.end()) {
        return false;
    }
    const auto contains = [this](const std::string& name) {
        return QString::fromStdString(name).contains(text, Qt::CaseInsensitive);
    };
    return text.isEmpty() || contains(event.name) || contains(event.otherName);
}

}  // namespace rubble
