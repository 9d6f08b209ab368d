#pragma once

#include "core/asset/Problems.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"

#include <QTimer>

#include <map>
#include <set>

namespace rubble {

/// The problems of every asset of a document, as it was baked last; looked for anew when bakes have come to rest.
class ProblemWatch : public QObject {
    Q_OBJECT
public:
    ProblemWatch(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    /// Of one asset; none where it was not looked at.
    const std::vector<Problem>& of(Id asset) const;
    /// Of all assets, in the project's order.
    std::vector<Problem> all() const;
    /// The bake that an asset's problems are of; null where it could not be baked.
    std::shared_ptr<const Bake> bakeOf(Id asset) const;

signals:
    void changed();

private:
    struct Found {
        std::shared_ptr<const Bake> bake;
        std::vector<Problem> ofBake;
        std::vector<Problem> problems;  // those, and those of its strength as the project is now
    };
    void look();

    const Document& m_document;
    const Bakes& m_bakes;
    QTimer m_rest;
    std::set<Id> m_stale;
    std::map<Id, Found> m_found;
};

}  // namespace rubble
