#include "editor/commands/InstanceEdits.h"

#include "core/asset/Names.h"
#include "core/asset/ScenePlacing.h"
#include "core/base/Trigonometry.h"

#include <QCoreApplication>

#include <algorithm>
#include <set>

namespace rubble {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("InstanceEdits", text); }
QString tr(const char* one, const char* many, std::size_t count) { return count == 1 ? tr(one) : tr(many).arg(count); }

bool isAmong(std::span<const Id> ids, Id id) { return std::ranges::find(ids, id) != ids.end(); }

std::vector<Instance> instancesWith(const Project& project, std::span<const Id> ids) {
    std::vector<Instance> instances;
    for (const Instance& instance : project.instances) {
        if (isAmong(ids, instance.id)) instances.push_back(instance);
    }
    return instances;
}

/// An edit that alters every instance that the function changes.
template <class Function>
Edit alteredInstances(const QString& text, const Project& project, const Function& change) {
    Edit edit{.text = text};
    for (const Instance& instance : project.instances) {
        Instance changed = instance;
        change(changed);
        if (!(changed == instance)) edit.swaps.push_back(Swap<Instance>{changed.id, std::move(changed)});
    }
    return edit;
}

/// Adds copies under ids and names of their own.
class Copying {
public:
    Copying(const QString& text, const Project& project)
        : m_project(project), m_edit{.text = text}, m_all(project.instances) {}

    void add(Instance copy) {
        copy.id = m_edit.takeId(m_project);
        copy.name = freeName(m_all, copy.name);
        m_all.push_back(copy);
        m_edit.swaps.push_back(Swap<Instance>{copy.id, std::move(copy)});
    }
    Edit finished() { return std::move(m_edit); }

private:
    const Project& m_project;
    Edit m_edit;
    std::vector<Instance> m_all;  // names of copies are taken, too
};

Pose turnedAbout(Vec2 middle, double angle, const Pose& pose) {
    const Quat turn{cosine(angle / 2.0), 0.0, sine(angle / 2.0), 0.0};
    const Vec3 axis{middle.x, 0.0, middle.y};
    return {axis + turn * (pose.position - axis), glm::normalize(turn * pose.orientation)};
}

/// The smallest number from 0 on that is not taken; it is taken then.
std::uint32_t freeVariant(std::set<std::uint32_t>& taken) {
    std::uint32_t variant = 0;
    while (!taken.insert(variant).second) ++variant;
    return variant;
}

double heightOf(const Instance& instance) { return instance.pose.position.y; }

}  // namespace

Edit gridOf(const Project& project, std::span<const Id> instances, const GridArray& array) {
    Copying copying(tr("Array in rows"), project);
    for (const Instance& instance : instancesWith(project, instances)) {
        for (int y = 0; y < array.counts[1]; ++y) {
            for (int z = 0; z < array.counts[2]; ++z) {
                for (int x = 0; x < array.counts[0]; ++x) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    Instance copy = instance;
                    copy.pose.position += Vec3(x, y, z) * array.steps;
                    copying.add(std::move(copy));
                }
            }
        }
    }
    return copying.finished();
}

Edit ringOf(const Project& project, std::span<const Id> instances, const RingArray& array) {
    Copying copying(tr("Array in a ring"), project);
    for (const Instance& instance : instancesWith(project, instances)) {
        for (int k = 1; k < array.count; ++k) {
            Instance copy = instance;
            copy.pose = turnedAbout(array.middle, k * array.turn, instance.pose);
            copying.add(std::move(copy));
        }
    }
    return copying.finished();
}

Addition placeInstance(const Project& project, Id asset, const Pose& pose) {
    Addition addition = addInstance(project, asset);
    for (AnySwap& swap : addition.edit.swaps) {
        if (auto* added = std::get_if<Swap<Instance>>(&swap)) added->value->pose = pose;
    }
    addition.edit.text = tr("Place instance");
    return addition;
}

Edit dropInstances(const Project& project, std::span<const Id> instances) {
    const AssetHulls hulls = assetHulls(project);
    std::vector<Instance> falling = instancesWith(project, instances);
    std::ranges::stable_sort(falling, {}, heightOf);
    std::vector<Instance> resting;
    for (const Instance& instance : project.instances) {
        if (!isAmong(instances, instance.id)) resting.push_back(instance);
    }
    Edit edit{.text = tr("Place on ground")};
    for (Instance& instance : falling) {
        const double fall = fallOf(instance, resting, project.ground, hulls);
        instance.pose.position.y -= fall;
        resting.push_back(instance);
        if (fall != 0.0) edit.swaps.push_back(Swap<Instance>{instance.id, instance});
    }
    return edit;
}

Edit spreadVariants(const Project& project, std::span<const Id> instances) {
    std::map<Id, std::set<std::uint32_t>> taken;  // by asset
    for (const Instance& instance : project.instances) {
        if (!isAmong(instances, instance.id)) taken[instance.asset].insert(instance.variant);
    }
    return alteredInstances(tr("Give variants"), project, [&](Instance& instance) {
        if (isAmong(instances, instance.id)) instance.variant = freeVariant(taken[instance.asset]);
    });
}

Edit hideInstances(const Project& project, std::span<const Id> instances) {
    return alteredInstances(tr("Hide instance", "Hide %1 instances", instances.size()), project,
                            [&](Instance& instance) { instance.isHidden |= isAmong(instances, instance.id); });
}

Edit isolateInstances(const Project& project, std::span<const Id> instances) {
    return alteredInstances(tr("Hide other instances"), project,
                            [&](Instance& instance) { instance.isHidden = !isAmong(instances, instance.id); });
}

Edit showAllInstances(const Project& project) {
    return alteredInstances(tr("Show all instances"), project, [](Instance& instance) { instance.isHidden = false; });
}

Edit lockInstances(const Project& project, std::span<const Id> instances) {
    return alteredInstances(tr("Lock instance", "Lock %1 instances", instances.size()), project,
                            [&](Instance& instance) { instance.isLocked |= isAmong(instances, instance.id); });
}

Edit unlockAllInstances(const Project& project) {
    return alteredInstances(tr("Unlock all instances"), project, [](Instance& instance) { instance.isLocked = false; });
}

Edit movedInstances(const QString& text, const Project& project, std::span<const Id> instances,
                    std::span<const Pose> poses, quint64 stroke) {
    Edit edit = alteredInstances(text, project, [&](Instance& instance) {
        const auto place = std::ranges::find(instances, instance.id);
        if (place != instances.end()) instance.pose = poses[static_cast<std::size_t>(place - instances.begin())];
    });
    edit.stroke = stroke;
    return edit;
}

const Instance* findInstance(const Project& project, Id id) {
    const auto found = std::ranges::find(project.instances, id, &Instance::id);
    return found != project.instances.end() ? &*found : nullptr;
}

}  // namespace rubble
