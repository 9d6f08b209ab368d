#pragma once

#include "core/base/TaskContext.h"
#include "core/play/SwapAudit.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"

#include <QObject>
#include <QThreadPool>

namespace rubble {

/// Audits the swap of an asset in the background, and keeps what came of it as long as the asset stays as it is.
class AssetTrials : public QObject {
    Q_OBJECT
public:
    AssetTrials(const Document& document, const Bakes& bakes, QObject* parent = nullptr);
    ~AssetTrials() override;

    bool isBusy() const { return m_isBusy; }
    void audit(Id asset);
    /// Null where the asset was not audited as it is.
    const SwapAudit* auditOf(Id asset) const;

signals:
    void changed();
    void said(const QString& sentence);

private:
    void forget(const Changes& changes);

    const Document& m_document;
    const Bakes& m_bakes;
    QThreadPool m_thread;
    int m_run = 0;  // what is of an earlier one comes too late
    bool m_isBusy = false;
    Id m_audited = 0;
    std::optional<SwapAudit> m_audit;
};

}  // namespace rubble
