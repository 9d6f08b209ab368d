#pragma once

#include "core/play/analysis/SwapAudit.h"
#include "editor/background/Derived.h"

namespace rubble {

/// Audits the swap of an asset on request and keeps the result until an asset or a material changes.
class SwapAuditRunner : public Derived<SwapAudit> {
    Q_DECLARE_TR_FUNCTIONS(rubble::SwapAuditRunner)
public:
    SwapAuditRunner(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    void audit(Id asset);
    /// Null if there is no result for the asset.
    const SwapAudit* auditOf(Id asset) const { return isCurrent() && m_asset == asset ? &value() : nullptr; }
    /// Null unless the audit of the asset failed.
    const Error* errorOf(Id asset) const { return error() && m_asset == asset ? &*error() : nullptr; }

private:
    const Bakes& m_bakes;
    Id m_asset = 0;  // of the last request
};

}  // namespace rubble
