#pragma once

#include "core/play/analysis/SwapAudit.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <optional>

namespace rubble {

/// Audits the swap of an asset in the background and keeps the result until an asset or a material changes.
class SwapAuditRunner : public QObject {
    Q_OBJECT
public:
    SwapAuditRunner(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    bool isBusy() const { return m_job.isRunning(); }
    void audit(Id asset);
    /// Null if there is no result for the asset.
    const SwapAudit* auditOf(Id asset) const;

signals:
    void changed();
    void statusMessage(const QString& sentence);

private:
    void discard(const Changes& changes);

    const Document& m_document;
    const Bakes& m_bakes;
    BackgroundJob m_job;
    Id m_asset = 0;  // of m_audit, or being audited
    std::optional<SwapAudit> m_audit;
};

}  // namespace rubble
