#include "editor/document/sections/Sections.h"

#include <algorithm>

namespace rubble {

SectionView Sections::of(Id asset) const {
    const auto found = m_views.find(asset);
    return found == m_views.end() ? SectionView() : found->second;
}

void Sections::set(Id asset, SectionView view) {
    view.position = std::clamp(view.position, 0.0, 1.0);
    if (view == of(asset)) return;
    m_views[asset] = view;
    emit changed(asset);
}

}  // namespace rubble

#include "moc_Sections.cpp"
