#include "editor/background/SwapAuditRunner.h"

namespace rubble {

SwapAuditRunner::SwapAuditRunner(const Document& document, const Bakes& bakes, QObject* parent)
    : Derived({document, {Part::Asset, Part::Material}, "checking the break stability", nullptr, OnChange::Discard}, {},
              parent),
      m_bakes(bakes) {}

void SwapAuditRunner::audit(Id asset) {
    if (asset != m_asset) reset();
    m_asset = asset;
    request([this, asset]() -> Result<Work> {
        const auto baked = m_bakes.find(asset);
        const Asset* authored = findAsset(project(), asset);
        if (authored == nullptr || !baked || !baked->bake || !(*baked->asset == *authored)) {
            return Error{ErrorCode::NotFound, tr("The asset is not baked yet; try again in a moment.").toStdString()};
        }
        return Work([project = project(), bake = baked->bake](const TaskContext& task, const Publish&) {
            return swapAudit(project, bake, task);
        });
    });
}

}  // namespace rubble
