#pragma once

#include "core/asset/Bake.h"
#include "core/base/Result.h"
#include "core/fracture/Delaunay.h"

#include <QObject>

#include <map>
#include <memory>

namespace rubble {

/// What became of an asset in one state: its bake, or the fault that kept it from being baked.
struct BakedAsset {
    std::shared_ptr<const Asset> asset;  // the state it was baked from
    std::shared_ptr<const Bake> bake;    // null where it failed
    Delaunay triangulation;              // of its seeds; without triangles where there are less than three
    std::optional<Error> fault;
};

/// The last finished result of every asset of a document. They stay until better ones come: what is shown may be a moment
/// older than the document.
class Bakes : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Null until the asset was baked once.
    std::shared_ptr<const BakedAsset> find(Id asset) const;
    const std::map<Id, std::shared_ptr<const BakedAsset>>& all() const { return m_results; }

    void set(Id asset, std::shared_ptr<const BakedAsset> result);
    void remove(Id asset);

signals:
    void changed(rubble::Id asset);

private:
    std::map<Id, std::shared_ptr<const BakedAsset>> m_results;
};

}  // namespace rubble
