#include "editor/background/SectionUpdater.h"

#include "core/asset/bake/FragmentLookup.h"
#include "editor/document/sections/SectionPattern.h"

namespace rubble {

SectionUpdater::SectionUpdater(const Selection& selection, const Sections& sections, Bakes& bakes, QObject* parent)
    : QObject(parent), m_selection(selection), m_sections(sections), m_bakes(bakes) {
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) refresh();
    });
    connect(&sections, &Sections::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) refresh();
    });
    connect(&selection, &Selection::assetChanged, this, &SectionUpdater::refresh);
    connect(&selection, &Selection::enteredFragmentChanged, this, &SectionUpdater::refresh);
}

void SectionUpdater::refresh() {
    const std::shared_ptr<const BakedAsset> baked = m_bakes.find(m_selection.asset());
    if (!baked || !baked->bake || baked->asset->isPrism()) return;
    const std::optional<std::uint32_t> parent = fragmentAt(*baked->bake, m_selection.enteredFragment());
    const BakedFracture* fracture = parent ? baked->bake->fractureOf(*parent) : nullptr;
    if (!fracture) return;
    const SectionView view = m_sections.of(m_selection.asset());
    const Key key{baked->bake, *parent, view.axis};
    if (!m_slicer || key != m_key) {
        const std::shared_ptr<const SolidPartition> partition(baked->bake, &fracture->fragments.solid()->partition);
        m_slicer = std::make_unique<const SolidSlicer>(partition, sectionPlane(view.axis, 0.0));
        m_key = key;
    }
    const double low = m_slicer->minHeight(), high = m_slicer->maxHeight();
    const SolidSection section = m_slicer->at(low + view.position * (high - low));
    m_bakes.setPattern(m_selection.asset(), sectionPattern(*baked->asset, *baked->bake, *fracture, section));
}

}  // namespace rubble

#include "moc_SectionUpdater.cpp"
