#pragma once

#include "core/asset/bake/AssetBakes.h"
#include "core/base/Result.h"
#include "core/fracture/delaunay/Delaunay.h"
#include "core/fracture/partition/Partition.h"
#include "core/fracture/planes/SectionPlane.h"

#include <QObject>

#include <map>
#include <memory>

namespace rubble {

/// The planar fracture of one state of an asset, or of one of its fragments. It is ready long before the fragments are.
struct BakedPattern {
    std::shared_ptr<const Asset> asset;  // the state it was made from; for a fragment, see fragmentAsAsset()
    Seeds seeds;
    Delaunay triangulation;        // of the seeds
    Partition partition;           // of the prism's outline
    std::optional<Error> fault;    // why it could not be made; then the rest is empty
    FragmentPath parent = {};      // the fragment that is fractured; empty: the whole asset
    Vec2 offset = Vec2(0.0, 0.0);  // of its frame in the asset's, m

    // Of a mesh, whose pattern is that of a section, see sectionPattern(): seeds have their heights above its plane.
    std::optional<SectionPlane> section = {};  // none: of a prism
    std::vector<Polygon> otherOutlines = {};   // of the section, beside that of the asset's prism
    std::vector<double> volumes = {};          // m³, of the fragment of each piece
};

/// One state of an asset with its bake, or the error that prevented it.
struct BakedAsset {
    std::shared_ptr<const Asset> asset;  // the state it was baked from
    std::shared_ptr<const Bake> bake;    // null if it failed
    std::optional<Error> fault;
    std::map<std::uint32_t, std::shared_ptr<const Bake>> variants;  // used by instances; without variant 0
};

/// The last finished results of every asset of a document. They stay until newer ones arrive: they may be a moment
/// older than the document, and the fragments a moment older than the pattern.
class Bakes : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Null until the first bake.
    std::shared_ptr<const BakedAsset> find(Id asset) const;
    const std::map<Id, std::shared_ptr<const BakedAsset>>& all() const { return m_results; }
    /// All bakes, by asset and variant.
    AssetBakes assetBakes() const;
    /// Whether every asset was baked in its current state and in all variants that instances use.
    bool areCurrent(const Project& project) const;

    /// The pattern of the whole asset, or of a fragment; null until it has been computed. Of the patterns of fragments,
    /// only the last one is kept.
    std::shared_ptr<const BakedPattern> findPattern(Id asset, const FragmentPath& parent = {}) const;

    void set(Id asset, std::shared_ptr<const BakedAsset> result);
    /// Sets the pattern of the whole asset or of a fragment, by BakedPattern::parent.
    void setPattern(Id asset, std::shared_ptr<const BakedPattern> pattern);
    void remove(Id asset);
    void clear();

signals:
    void changed(rubble::Id asset);
    void patternChanged(rubble::Id asset);

private:
    std::map<Id, std::shared_ptr<const BakedAsset>> m_results;
    std::map<Id, std::shared_ptr<const BakedPattern>> m_patterns;
    std::shared_ptr<const BakedPattern> m_fragmentPattern;  // the last one of a fragment; may be null
};

}  // namespace rubble
