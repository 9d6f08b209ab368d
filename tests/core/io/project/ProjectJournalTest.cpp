#include "core/io/project/ProjectJournal.h"

#include "core/asset/library/StarterProject.h"
#include "core/base/Random.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

/// A project with three instances, and the states after edits of it.
std::vector<Project> states(std::uint64_t seed, int edits) {
    Random random(seed);
    std::vector<Project> all{starterProject()};
    for (int k = 0; k < edits; ++k) {
        Project next = all.back();
        next.ground.height = random.unit();
        if (random.unit() < 0.5 || next.instances.size() < 2) {
            Instance instance = next.instances[0];
            instance.id = next.nextId++;
            instance.name = "wall " + std::to_string(instance.id);
            next.instances.push_back(instance);
        } else {
            next.instances.pop_back();
            next.assets[0].prism().depth += random.unit();
        }
        all.push_back(std::move(next));
    }
    return all;
}

/// What leads from one state to another.
ProjectPart partBetween(const Project& before, const Project& after) {
    ProjectPart part{.values = after};
    part.values.materials.clear();
    for (const Instance& instance : before.instances) {
        if (findInstance(after, instance.id) == nullptr) part.removedInstances.push_back(instance.id);
    }
    return part;
}

struct Journal {
    std::string text;
    std::vector<std::size_t> ends;  // of its records
};

Journal journalOf(const std::vector<Project>& all) {
    ContentHash seal = contentHash(projectText(all[0]));
    Journal journal{.text = journalStart(seal)};
    journal.ends.push_back(journal.text.size());
    for (std::size_t k = 1; k < all.size(); ++k) {
        journal.text += journalRecord(partBetween(all[k - 1], all[k]), seal);
        journal.ends.push_back(journal.text.size());
    }
    return journal;
}

}  // namespace

class ProjectJournalTest : public QObject {
    Q_OBJECT
private slots:
    void everyPrefixGivesTheStateOfItsLastWholeRecord() {
        const std::vector<Project> all = states(3, 8);
        const ContentHash text = contentHash(projectText(all[0]));
        const Journal journal = journalOf(all);
        for (std::size_t size = 0; size <= journal.text.size(); size += size % 7 + 1) {
            const auto whole = std::ranges::upper_bound(journal.ends, size) - journal.ends.begin();
            const Project& expected = all[static_cast<std::size_t>(std::max<std::ptrdiff_t>(whole, 1) - 1)];
            QVERIFY(replayed(all[0], text, std::string_view(journal.text).substr(0, size)).value() == expected);
        }
        QVERIFY(replayed(all[0], text, journal.text).value() == all.back());
    }
    void changedBytesEndTheJournal() {
        const std::vector<Project> all = states(4, 5);
        const ContentHash text = contentHash(projectText(all[0]));
        const Journal journal = journalOf(all);
        Random random(5);
        for (int k = 0; k < 1000; ++k) {
            std::string bad = journal.text;
            const auto at = static_cast<std::size_t>(random.unit() * static_cast<double>(bad.size()));
            bad[at] = static_cast<char>(bad[at] ^ (1 << (k % 8)));
            const auto whole = std::ranges::upper_bound(journal.ends, at) - journal.ends.begin();
            const Project& expected = all[static_cast<std::size_t>(std::max<std::ptrdiff_t>(whole, 1) - 1)];
            const Result<Project> found = replayed(all[0], text, bad);
            QVERIFY2(found && *found == expected, qPrintable(QString("byte %1").arg(at)));
        }
    }
    void editsOfAnotherTextAreLeftOut() {
        const std::vector<Project> all = states(6, 3);
        QVERIFY(replayed(all[0], contentHash("another"), journalOf(all).text).value() == all[0]);
    }
    void recordsAreTakenInTheirOrder() {
        const std::vector<Project> all = states(7, 3);
        const Journal journal = journalOf(all);
        const auto part = [&](std::size_t k) {
            return journal.text.substr(journal.ends[k], journal.ends[k + 1] - journal.ends[k]);
        };
        const std::string swapped = journal.text.substr(0, journal.ends[0]) + part(1) + part(0) + part(2);
        QVERIFY(replayed(all[0], contentHash(projectText(all[0])), swapped).value() == all[0]);
    }
};

RUBBLE_TEST(ProjectJournalTest)
#include "ProjectJournalTest.moc"
