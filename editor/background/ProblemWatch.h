#pragma once

#include "core/asset/checks/Problems.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QTimer>

#include <map>
#include <memory>
#include <set>
#include <vector>

namespace rubble {

/// The problems of every asset's last bake, and of its instances in the scene. Searches again, in the background, when
/// these have not changed for a moment; a search of bakes that change meanwhile is cancelled.
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
    /// The problems could not be searched for; the sentence says why.
    void statusMessage(const QString& sentence);

private:
    struct Entry {
        std::shared_ptr<const Bake> bake;
        std::vector<Diagnostic> ofBake;
        std::vector<Diagnostic> problems;  // ofBake, those of its strength in the current project and of its instances
    };
    struct Found {
        std::vector<std::vector<Diagnostic>> ofBakes;
        std::vector<Diagnostic> ofScene;
    };
    using Baked = std::vector<std::shared_ptr<const BakedAsset>>;

    void check();
    /// Applies the problems of each bake.
    void apply(const Baked& baked, Found all);

    const Document& m_document;
    const Bakes& m_bakes;
    BackgroundJob m_job;
    QTimer m_delay;
    std::set<Id> m_stale;  // whose bakes changed since the last result
    std::map<Id, Entry> m_results;
};

}  // namespace rubble
