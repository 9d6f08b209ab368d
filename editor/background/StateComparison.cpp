#include "editor/background/StateComparison.h"

namespace rubble {

StateComparison::StateComparison(const Document& document, const Selection& selection, const Bakes& bakes,
                                 QObject* parent)
    : Derived({document, {Part::Asset, Part::Material}, "comparing the asset", nullptr, OnChange::Restart, 0}, {},
              parent),
      m_selection(selection),
      m_bakes(bakes) {
    connect(&selection, &Selection::assetChanged, this, [this] {
        if (isOn()) restart();
    });
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) invalidate();
    });
}

void StateComparison::begin(std::shared_ptr<const Project> earlier, const QString& name) {
    reset();
    m_earlier = std::move(earlier);
    m_name = name;
    request([this] { return prepare(); });
}

void StateComparison::end() {
    m_earlier = nullptr;
    reset();
}

Result<StateComparison::Work> StateComparison::prepare() const {
    const Asset* asset = findAsset(project(), m_selection.asset());
    const auto baked = m_bakes.find(m_selection.asset());
    if (asset == nullptr || !baked || !(*baked->asset == *asset)) return Work();
    if (!baked->bake) return baked->fault.value_or(Error{ErrorCode::BadInput, "The asset cannot be baked."});
    return Work(
        [earlier = m_earlier, now = project(), after = baked->bake, before = value() ? value()->before : nullptr](
            const TaskContext& task, const Publish&) { return comparedAsset(*earlier, before, now, after, task); });
}

}  // namespace rubble
