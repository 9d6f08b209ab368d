#pragma once

#include "core/asset/AssetBakes.h"
#include "core/base/Result.h"
#include "core/fracture/Delaunay.h"
#include "core/fracture/Partition.h"

#include <QObject>

#include <map>
#include <memory>

namespace rubble {

/// What the pattern of an asset in one state gives in the plane, or that of one of its fragments; there long before the fragments.
struct BakedPattern {
    std::shared_ptr<const Asset> asset;  // the state it was made from; a fragment's as asWhole() has it
    Seeds seeds;
    Delaunay triangulation;        // of the seeds
    Partition partition;           // of the prism's outline
    std::optional<Error> fault;    // what kept it from being made; the rest is empty then
    FragmentPath inside = {};      // the fragment that is broken; empty: the whole
    Vec2 offset = Vec2(0.0, 0.0);  // of its frame in the asset's, m
};

/// What became of an asset in one state: its bake, or the fault that kept it from being baked.
struct BakedAsset {
    std::shared_ptr<const Asset> asset;  // the state it was baked from
    std::shared_ptr<const Bake> bake;    // null where it failed
    std::optional<Error> fault;
    std::map<std::uint32_t, std::shared_ptr<const Bake>> variants;  // others than 0 that instances use
};

/// The last finished results of every asset of a document. They stay until better ones come: what is shown may be a moment
/// older than the document, and the fragments a moment older than the pattern.
class Bakes : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Null until the asset was baked once.
    std::shared_ptr<const BakedAsset> find(Id asset) const;
    const std::map<Id, std::shared_ptr<const BakedAsset>>& all() const { return m_results; }
    /// What there is, by asset and variant.
    AssetBakes assetBakes() const;
    /// Whether every asset was baked as the project has it, in all variants that its instances use.
    bool areCurrent(const Project& project) const;

    /// Null until the pattern of the asset's whole was made once, or that inside a fragment: of those there is the last one made.
    std::shared_ptr<const BakedPattern> findPattern(Id asset, const FragmentPath& inside = {}) const;

    void set(Id asset, std::shared_ptr<const BakedAsset> result);
    /// Of the whole or of a fragment, as the pattern says.
    void setPattern(Id asset, std::shared_ptr<const BakedPattern> pattern);
    void remove(Id asset);
    void clear();

signals:
    void changed(rubble::Id asset);
    void patternChanged(rubble::Id asset);

private:
    std::map<Id, std::shared_ptr<const BakedAsset>> m_results;
    std::map<Id, std::shared_ptr<const BakedPattern>> m_patterns;
    std::shared_ptr<const BakedPattern> m_inside;  // of a fragment; null where none was made
};

}  // namespace rubble
