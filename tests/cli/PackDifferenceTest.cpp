// Tests app/cli/output/PackDifference.cpp and PackFolders.cpp.
#include "app/cli/output/PackDifference.h"

#include "app/cli/output/PackFolders.h"
#include "core/io/pack/PackExport.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>

using namespace rubble;

namespace {

namespace fs = std::filesystem;

/// The pack of a box of three fragments.
ExportedPack packOfBox(const fs::path& folder) {
    Project project = boxProject(UniformScatter{.count = 3});
    const auto exported = exportPacks(project, std::vector{project.assets[0].id}, folder, {});
    if (!exported || !exported->front().status) qFatal("cannot export");
    Result<ExportedPack> pack = loadExportedPack(exported->front().folder);
    if (!pack) qFatal("%s", pack.error().message.c_str());
    return std::move(*pack);
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

using Change = std::function<void(Pack&)>;
using BodyChange = std::function<void(PackBody&)>;

}  // namespace

Q_DECLARE_METATYPE(Change)
Q_DECLARE_METATYPE(BodyChange)

class PackDifferenceTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_place;
    ExportedPack m_box = packOfBox(m_place.filePath("packs").toStdString());

private slots:
    void packIsTheSameAsItself() {
        const PackDifference difference = packDifference(&m_box, &m_box);
        QVERIFY(!difference.change && difference.fields.empty() && difference.fragments.empty());
        QCOMPARE(packDifferenceText(difference, 10), m_box.pack.names.name + ": same\n");
    }
    void changedFieldsAreReported_data() {
        QTest::addColumn<Change>("change");
        QTest::addColumn<std::string>("what");
        const auto row = [](const char* what, Change change) { QTest::newRow(what) << change << std::string(what); };
        row("asset", [](Pack& pack) { pack.names.name = "other"; });
        row("threshold in N·s", [](Pack& pack) { pack.threshold = 12.5; });
        row("material", [](Pack& pack) { pack.materials[0].name = "other"; });
        row("density in kg/m³", [](Pack& pack) { pack.materials[0].density = 12.5; });
        row("friction", [](Pack& pack) { pack.materials[0].friction = 0.125; });
        row("restitution", [](Pack& pack) { pack.materials[0].restitution = 0.125; });
        row("outside colour", [](Pack& pack) { pack.materials[0].outside.red = 0.125; });
        row("inside colour", [](Pack& pack) { pack.materials[0].inside.blue = 0.125; });
        row("opacity", [](Pack& pack) { pack.materials[0].opacity = 0.125; });
        row("gap in m", [](Pack& pack) { pack.gap = 0.125; });
        row("breaks along bonds", [](Pack& pack) { pack.bonding.emplace(); });
        row("meshes", [](Pack& pack) { pack.meshes.pop_back(); });
        row("placement", [](Pack& pack) { pack.meshes.front().place = PartPlacement::Centred; });
        row("hash", [](Pack& pack) { pack.hash = "0123"; });
    }
    void changedFieldsAreReported() {
        QFETCH(const Change, change);
        QFETCH(const std::string, what);
        ExportedPack changed = m_box;
        change(changed.pack);
        const PackDifference difference = packDifference(&m_box, &changed);
        QVERIFY(difference.change == PackChange::Changed);
        QCOMPARE(difference.fields.size(), 1U);
        QCOMPARE(difference.fields[0].what, what);
        QVERIFY(difference.fields[0].before != difference.fields[0].after);
        QVERIFY(difference.fragments.empty());
    }
    void changesOfAFragmentAreReported_data() {
        QTest::addColumn<BodyChange>("change");
        QTest::addColumn<std::string>("fields");
        const auto row = [](const char* fields, BodyChange change) {
            QTest::newRow(fields) << change << std::string(fields);
        };
        row("parent", [](PackBody& body) { body.parent = 0; });
        row("offset", [](PackBody& body) { body.offset.x += 1.0; });
        row("volume", [](PackBody& body) { body.volume *= 2.0; });
        row("mass", [](PackBody& body) { body.mass *= 2.0; });
        row("centre of mass", [](PackBody& body) { body.centreOfMass.y += 1.0; });
        row("inertia", [](PackBody& body) { body.inertia[1][1] *= 2.0; });
        row("neighbours", [](PackBody& body) { body.neighbours.pop_back(); });
        row("threshold", [](PackBody& body) { body.threshold = 2.0; });
        row("gap", [](PackBody& body) { body.lostMass = 2.0; });
        row("hulls", [](PackBody& body) { body.hulls[0].polytope.vertices[0].z += 1.0; });
        row("volume, mass", [](PackBody& body) {
            body.volume *= 2.0;
            body.mass *= 2.0;
        });
    }
    void changesOfAFragmentAreReported() {
        QFETCH(const BodyChange, change);
        QFETCH(const std::string, fields);
        ExportedPack changed = m_box;
        change(changed.pack.fragments[1]);
        const PackDifference difference = packDifference(&m_box, &changed);
        QCOMPARE(difference.fragments.size(), 1U);
        QVERIFY(m_box.pack.fragments[1].id.ends_with("/" + difference.fragments[0].name));
        QCOMPARE(joined(difference.fragments[0].fields), fields);
    }
    void fragmentsAreMatchedByTheirPaths() {
        ExportedPack changed = m_box;
        for (PackBody& fragment : changed.pack.fragments)
            fragment.id = "99" + fragment.id.substr(fragment.id.find('/'));
        std::swap(changed.pack.fragments[0], changed.pack.fragments[2]);
        for (PackBody& fragment : changed.pack.fragments) {
            for (PackNeighbour& contact : fragment.neighbours) contact.fragment = 2 - contact.fragment;
        }
        QVERIFY(packDifference(&m_box, &changed).fragments.empty());
    }
    void removedAndAddedFragmentsAreReported() {
        ExportedPack fewer = m_box;
        fewer.pack.fragments.pop_back();
        for (PackBody& fragment : fewer.pack.fragments)
            std::erase_if(fragment.neighbours, [](const PackNeighbour& contact) { return contact.fragment == 2; });
        const auto hasChange = [](const PackDifference& difference, PackChange change) {
            return std::ranges::count(difference.fragments, change, &PackItemChange::change) == 1;
        };
        QVERIFY(hasChange(packDifference(&m_box, &fewer), PackChange::Removed));
        QVERIFY(hasChange(packDifference(&fewer, &m_box), PackChange::Added));
        const std::string text = packDifferenceText(packDifference(&fewer, &m_box), 10);
        QVERIFY2(text.find("3 fragments, were 2: 1 added") != std::string::npos, text.c_str());
    }
    void packsMayBeAddedAndRemoved() {
        QCOMPARE(packDifferenceText(packDifference(nullptr, &m_box), 10),
                 m_box.pack.names.name + ": added, 3 fragments\n");
        QCOMPARE(packDifferenceText(packDifference(&m_box, nullptr), 10),
                 m_box.pack.names.name + ": removed, had 3 fragments\n");
    }
    void filesOfTheManifestsAreCompared() {
        ExportedPack changed = m_box;
        std::vector<ManifestEntry>& files = changed.manifest->files;
        for (ManifestEntry& file : files) file.hash = "0";
        files.pop_back();
        files.push_back({"new.obj", 1, "1"});
        const PackDifference difference = packDifference(&m_box, &changed);
        QCOMPARE(difference.files.size(), files.size());  // without pack.json, with the removed one
        for (const PackItemChange& file : difference.files) {
            const bool isRemoved = file.name == m_box.manifest->files.back().name, isAdded = file.name == "new.obj";
            QVERIFY(file.name != kPackName);
            QVERIFY(file.change == (isRemoved ? PackChange::Removed
                                    : isAdded ? PackChange::Added
                                              : PackChange::Changed));
        }
        changed.manifest.reset();
        QVERIFY(packDifference(&m_box, &changed).files.empty());
    }
    void longListsAreCut() {
        ExportedPack changed = m_box;
        for (PackBody& fragment : changed.pack.fragments) fragment.volume *= 2.0;
        const std::string text = packDifferenceText(packDifference(&m_box, &changed), 2);
        QVERIFY2(text.ends_with("  … and 1 more changed; --all lists them\n"), text.c_str());
    }
    void foldersOfPacksAreFound() {
        const fs::path packs = m_place.filePath("packs").toStdString();
        const auto found = packsOf(packs);
        QVERIFY(found.hasValue() && found->size() == 1);
        QVERIFY(isPack(found->front()) && !isPack(packs));
        QCOMPARE(packsOf(found->front())->front(), found->front());
        QVERIFY(packsOf(found->front() / "nothing").error().code == ErrorCode::Io ||
                packsOf(found->front() / "nothing").error().code == ErrorCode::NotFound);
    }
};

RUBBLE_TEST(PackDifferenceTest)
#include "PackDifferenceTest.moc"
