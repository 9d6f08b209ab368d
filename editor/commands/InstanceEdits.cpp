#include "editor/commands/InstanceEdits.h"

#include "core/asset/placement/InstancePlacement.h"
#include "core/asset/project/Ids.h"
#include "core/asset/project/Names.h"
#include "core/base/math/Trigonometry.h"

#include <QCoreApplication>

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <set>

namespace rubble {

namespace {

struct InstanceEditsTexts {
    Q_DECLARE_TR_FUNCTIONS(InstanceEdits)
};

std::vector<Instance> instancesWith(const Project& project, std::span<const Id> ids) {
    std::vector<Instance> instances;
    for (const Instance& instance : project.instances) {
        if (isAmong(ids, instance.id)) instances.push_back(instance);
    }
    return instances;
}

/// An edit with every instance that the function changes.
template <class Function>
Edit editInstances(const QString& text, const Project& project, const Function& change) {
    Edit edit{.text = text};
    for (const Instance& instance : project.instances) {
        Instance changed = instance;
        change(changed);
        if (!(changed == instance)) edit.replacements.push_back(Replacement<Instance>{changed.id, std::move(changed)});
    }
    return edit;
}

/// Collects copies, each with a fresh id and a unique name.
class InstanceCopies {
public:
    InstanceCopies(const QString& text, const Project& project)
        : m_project(project), m_edit{.text = text}, m_all(project.instances) {}

    void add(Instance copy) {
        copy.id = m_edit.allocateId(m_project);
        copy.name = uniqueName(m_all, copy.name);
        m_all.push_back(copy);
        m_edit.replacements.push_back(Replacement<Instance>{copy.id, std::move(copy)});
    }
    Edit finished() { return std::move(m_edit); }

private:
    const Project& m_project;
    Edit m_edit;
    std::vector<Instance> m_all;  // with the copies, whose names must be unique, too
};

Pose rotatedAbout(Vec2 centre, double angle, const Pose& pose) {
    const Quat rotation{cosine(angle / 2.0), 0.0, sine(angle / 2.0), 0.0};
    const Vec3 axis{centre.x, 0.0, centre.y};
    return {axis + rotation * (pose.position - axis), glm::normalize(rotation * pose.orientation)};
}

/// Reserves the lowest variant that is not taken.
std::uint32_t reserveVariant(std::set<std::uint32_t>& taken) {
    std::uint32_t variant = 0;
    while (!taken.insert(variant).second) ++variant;
    return variant;
}

double heightOf(const Instance& instance) { return instance.pose.position.y; }

}  // namespace

Edit arrayInGrid(const Project& project, std::span<const Id> instances, const GridArray& array) {
    InstanceCopies copies(InstanceEditsTexts::tr("Grid Array"), project);
    for (const Instance& instance : instancesWith(project, instances)) {
        for (int y = 0; y < array.counts[1]; ++y) {
            for (int z = 0; z < array.counts[2]; ++z) {
                for (int x = 0; x < array.counts[0]; ++x) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    Instance copy = instance;
                    copy.pose.position += Vec3(x, y, z) * array.steps;
                    copies.add(std::move(copy));
                }
            }
        }
    }
    return copies.finished();
}

Edit arrayInRing(const Project& project, std::span<const Id> instances, const RingArray& array) {
    InstanceCopies copies(InstanceEditsTexts::tr("Radial Array"), project);
    for (const Instance& instance : instancesWith(project, instances)) {
        for (int k = 1; k < array.count; ++k) {
            Instance copy = instance;
            copy.pose = rotatedAbout(array.centre, k * array.angle, instance.pose);
            copies.add(std::move(copy));
        }
    }
    return copies.finished();
}

Addition placeInstance(const Project& project, Id asset, const Pose& pose) {
    Addition addition = addInstance(project, asset);
    for (AnyReplacement& replacement : addition.edit.replacements) {
        if (auto* added = std::get_if<Replacement<Instance>>(&replacement)) added->value->pose = pose;
    }
    addition.edit.text = InstanceEditsTexts::tr("Place Instance");
    return addition;
}

Edit dropToGround(const Project& project, std::span<const Id> instances) {
    const AssetHulls hulls = assetHulls(project);
    std::vector<Instance> falling = instancesWith(project, instances);
    std::ranges::stable_sort(falling, {}, heightOf);
    std::vector<Instance> resting;
    for (const Instance& instance : project.instances) {
        if (!isAmong(instances, instance.id)) resting.push_back(instance);
    }
    Edit edit{.text = InstanceEditsTexts::tr("Drop to Ground")};
    for (Instance& instance : falling) {
        const double fall = dropDistance(instance, resting, project.ground, hulls);
        instance.pose.position.y -= fall;
        resting.push_back(instance);
        if (fall != 0.0) edit.replacements.push_back(Replacement<Instance>{instance.id, instance});
    }
    return edit;
}

Edit assignDistinctVariants(const Project& project, std::span<const Id> instances) {
    std::map<Id, std::set<std::uint32_t>> taken;  // by asset
    for (const Instance& instance : project.instances) {
        if (!isAmong(instances, instance.id)) taken[instance.asset].insert(instance.variant);
    }
    return editInstances(InstanceEditsTexts::tr("Assign Distinct Variants"), project, [&](Instance& instance) {
        if (isAmong(instances, instance.id)) instance.variant = reserveVariant(taken[instance.asset]);
    });
}

Edit hideInstances(const Project& project, std::span<const Id> instances) {
    const int count = static_cast<int>(instances.size());
    return editInstances(InstanceEditsTexts::tr("Hide %n Instance(s)", nullptr, count), project,
                         [&](Instance& instance) { instance.isHidden |= isAmong(instances, instance.id); });
}

Edit isolateInstances(const Project& project, std::span<const Id> instances) {
    return editInstances(InstanceEditsTexts::tr("Hide Other Instances"), project,
                         [&](Instance& instance) { instance.isHidden = !isAmong(instances, instance.id); });
}

Edit showAllInstances(const Project& project) {
    return editInstances(InstanceEditsTexts::tr("Show All Instances"), project,
                         [](Instance& instance) { instance.isHidden = false; });
}

Edit lockInstances(const Project& project, std::span<const Id> instances) {
    const int count = static_cast<int>(instances.size());
    return editInstances(InstanceEditsTexts::tr("Lock %n Instance(s)", nullptr, count), project,
                         [&](Instance& instance) { instance.isLocked |= isAmong(instances, instance.id); });
}

Edit unlockAllInstances(const Project& project) {
    return editInstances(InstanceEditsTexts::tr("Unlock All Instances"), project,
                         [](Instance& instance) { instance.isLocked = false; });
}

std::vector<Id> bondedInstances(const Project& project, std::span<const Id> instances) {
    std::vector<Id> bonded;
    for (const Instance& instance : instancesWith(project, instances)) {
        const Asset* asset = findAsset(project, instance.asset);
        if (asset && asset->breakAs == BreakAs::Bonded) bonded.push_back(instance.id);
    }
    return bonded;
}

bool areAnchored(const Project& project, std::span<const Id> instances) {
    const std::vector<Instance> bonded = instancesWith(project, bondedInstances(project, instances));
    return !bonded.empty() && std::ranges::all_of(bonded, &Instance::isAnchored);
}

Edit toggleAnchored(const Project& project, std::span<const Id> instances) {
    const std::vector<Id> bonded = bondedInstances(project, instances);
    const bool isAnchored = !areAnchored(project, bonded);
    const int count = static_cast<int>(bonded.size());
    const QString text = isAnchored ? InstanceEditsTexts::tr("Anchor %n Instance(s)", nullptr, count)
                                    : InstanceEditsTexts::tr("Release %n Instance(s)", nullptr, count);
    return editInstances(text, project, [&](Instance& instance) {
        if (isAmong(bonded, instance.id)) instance.isAnchored = isAnchored;
    });
}

Edit moveInstances(const QString& text, const Project& project, std::span<const Id> instances,
                   std::span<const Pose> poses, quint64 mergeKey) {
    Edit edit = editInstances(text, project, [&](Instance& instance) {
        const auto found = std::ranges::find(instances, instance.id);
        if (found != instances.end()) instance.pose = poses[static_cast<std::size_t>(found - instances.begin())];
    });
    edit.mergeKey = mergeKey;
    return edit;
}

}  // namespace rubble
