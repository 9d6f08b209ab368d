#include "editor/background/SwapAuditRunner.h"

namespace rubble {

SwapAuditRunner::SwapAuditRunner(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    connect(&document, &Document::changed, this, &SwapAuditRunner::discard);
}

void SwapAuditRunner::discard(const Changes& changes) {
    if (!changes.isEverything && !changes.touches(Part::Asset) && !changes.touches(Part::Material)) return;
    m_job.cancel();
    m_audit.reset();
    emit changed();
}

const SwapAudit* SwapAuditRunner::auditOf(Id asset) const { return m_audit && m_asset == asset ? &*m_audit : nullptr; }

void SwapAuditRunner::audit(Id asset) {
    const auto baked = m_bakes.find(asset);
    const Asset* authored = findAsset(m_document.project(), asset);
    if (authored == nullptr || !baked || !baked->bake || !(*baked->asset == *authored)) {
        return emit statusMessage(tr("The asset is not baked yet; try again in a moment."));
    }
    m_asset = asset;
    m_audit.reset();
    m_job.start(
        [project = m_document.project(), authored = *authored,
         bake = baked->bake](const TaskContext&) -> Result<SwapAudit> {
            const Result<std::shared_ptr<const PlayAsset>> ready = playAsset(authored, bake, {});
            if (!ready) return ready.error();
            return swapAudit(project, *ready);
        },
        [this](const Result<SwapAudit>& audit) {
            if (audit) m_audit = *audit;
            emit changed();
            if (!audit) emit statusMessage(QString::fromStdString(audit.error().message));
        });
    emit changed();
}

}  // namespace rubble

#include "moc_SwapAuditRunner.cpp"
