#include "editor/play/AssetTrials.h"

#include <QMetaObject>

namespace rubble {

AssetTrials::AssetTrials(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    m_thread.setMaxThreadCount(1);
    connect(&document, &Document::changed, this, &AssetTrials::forget);
}

AssetTrials::~AssetTrials() { m_thread.waitForDone(); }

void AssetTrials::forget(const Changes& changes) {
    if (!changes.isEverything && !changes.touches(Part::Asset) && !changes.touches(Part::Material)) return;
    ++m_run;
    m_isBusy = false;
    m_audit.reset();
    emit changed();
}

const SwapAudit* AssetTrials::auditOf(Id asset) const { return m_audit && m_audited == asset ? &*m_audit : nullptr; }

void AssetTrials::audit(Id asset) {
    const auto baked = m_bakes.find(asset);
    const Asset* authored = findAsset(m_document.project(), asset);
    if (authored == nullptr || !baked || !baked->bake || !(*baked->asset == *authored)) {
        return emit said(tr("It is not baked yet; try again in a moment."));
    }
    const int run = ++m_run;
    m_isBusy = true;
    m_audited = asset;
    m_audit.reset();
    emit changed();
    m_thread.start([this, run, project = m_document.project(), authored = *authored, bake = baked->bake] {
        const auto audited = [&]() -> Result<SwapAudit> {
            const Result<std::shared_ptr<const PlayAsset>> ready = playAsset(authored, bake, {});
            if (!ready) return ready.error();
            return swapAudit(project, *ready);
        };
        QMetaObject::invokeMethod(this, [this, run, outcome = audited()] {
            if (run != m_run) return;
            m_isBusy = false;
            if (outcome) m_audit = *outcome;
            emit changed();
            if (!outcome) emit said(QString::fromStdString(outcome.error().message));
        });
    });
}

}  // namespace rubble
