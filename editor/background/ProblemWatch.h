#pragma once

#include "core/asset/checks/Problems.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"

#include <QTimer>

#include <map>
#include <set>

namespace rubble {

/// The problems of every asset's last bake; searched again when the bakes have not changed for a moment.
class ProblemWatch : public QObject {
    Q_OBJECT
public:
    ProblemWatch(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    /// The problems of an asset; none if it was not checked yet.
    const std::vector<Diagnostic>& of(Id asset) const;
    /// The problems of all assets, in the project's order.
    std::vector<Diagnostic> all() const;
    /// The bake in which an asset's problems were found; null if it could not be baked.
    std::shared_ptr<const Bake> bakeOf(Id asset) const;

signals:
    void changed();

private:
    struct Entry {
        std::shared_ptr<const Bake> bake;
        std::vector<Diagnostic> ofBake;
        std::vector<Diagnostic> problems;  // ofBake and those of its strength in the current project
    };
    void check();

    const Document& m_document;
    const Bakes& m_bakes;
    QTimer m_delay;
    std::set<Id> m_stale;
    std::map<Id, Entry> m_results;
};

}  // namespace rubble
