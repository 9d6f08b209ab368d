#include "core/io/pack/ImporterProblems.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <string>

using namespace rubble;

namespace {

/// A pack with files in a folder whose name has `folder` bytes; the longest file name has `file`.
PackListing listing(std::size_t folder, std::size_t file) {
    return {std::string(folder, 'w'), {.names = {"pack.json", std::string(file, 'f'), "wall.obj"}}};
}

std::vector<DiagnosticCode> codesOf(const std::vector<Diagnostic>& problems) {
    std::vector<DiagnosticCode> codes;
    for (const Diagnostic& problem : problems) codes.push_back(problem.code);
    return codes;
}

PackBody bodyWithCorners(const std::string& name, std::size_t corners) {
    PackBody body{.name = name};
    body.hulls.resize(2);
    body.hulls[0].polytope.vertices.resize(4);
    body.hulls[1].polytope.vertices.resize(corners);
    return body;
}

}  // namespace

class ImporterProblemsTest : public QObject {
    Q_OBJECT
private slots:
    void materialsThatGodotActsOnAreNamed() {
        const std::vector<PackSurface> surfaces{{.name = "bark"}, {.name = "leaf_alpha"}, {.name = "moss-vcol"}};
        const std::vector<Diagnostic> problems = surfaceNameProblems(surfaces);
        QCOMPARE(problems.size(), std::size_t{2});
        QVERIFY(problems[0].code == DiagnosticCode::ImporterName && problems[0].severity == Severity::Warning);
        QCOMPARE(problems[0].message,
                 "Godot's importer acts on the end of the name of the material \"leaf_alpha\" and makes it "
                 "transparent; rename it.");
        QVERIFY(problems[1].message.find("\"moss-vcol\"") != std::string::npos);
        QVERIFY(surfaceNameProblems({}).empty());
    }
    /// Blender's names have 63 bytes, of which "_1" and so on are two.
    void namesThatBlenderCuts() {
        QVERIFY(nameLengthProblems(listing(61, 20)).empty());
        const std::vector<Diagnostic> problems = nameLengthProblems(listing(62, 20));
        QVERIFY(codesOf(problems) == std::vector{DiagnosticCode::LongName});
        QVERIFY(problems[0].message.starts_with("Blender cuts names at 63 bytes"));
        QCOMPARE(problems[0].value, 64.0);
        QCOMPARE(problems[0].limit, 63.0);
    }
    /// 180 of 260 bytes: the folders above take the rest.
    void pathsThatWindowsCannotOpen() {
        QVERIFY(nameLengthProblems(listing(20, 159)).empty());
        const std::vector<Diagnostic> problems = nameLengthProblems(listing(20, 160));
        QVERIFY(codesOf(problems) == std::vector{DiagnosticCode::LongPath});
        QVERIFY(problems[0].message.starts_with("Its files have paths of 181 bytes"));
        QVERIFY(codesOf(nameLengthProblems(listing(100, 160))) ==
                (std::vector{DiagnosticCode::LongName, DiagnosticCode::LongPath}));
    }
    void onlyTheLargestHullIsReported_data() {
        QTest::addColumn<unsigned>("corners");
        QTest::addColumn<int>("severity");
        QTest::newRow("for the graphics card") << 64u << -1;
        QTest::newRow("for the processor") << 65u << static_cast<int>(Severity::Note);
        QTest::newRow("the most that PhysX takes") << 255u << static_cast<int>(Severity::Note);
        QTest::newRow("too many") << 256u << static_cast<int>(Severity::Warning);
    }
    void onlyTheLargestHullIsReported() {
        QFETCH(unsigned, corners);
        QFETCH(int, severity);
        Pack pack;
        pack.whole = bodyWithCorners("wall_whole", 8);
        pack.fragments = {bodyWithCorners("wall_f1", 30), bodyWithCorners("wall_f2", corners)};
        const std::vector<Diagnostic> problems = hullCornerProblems(pack);
        QCOMPARE(problems.size(), severity < 0 ? std::size_t{0} : std::size_t{1});
        if (problems.empty()) return;
        QVERIFY(problems[0].code == DiagnosticCode::ManyHullCorners);
        QCOMPARE(static_cast<int>(problems[0].severity), severity);
        QVERIFY(problems[0].message.starts_with("A hull of \"wall_f2\" has " + std::to_string(corners)));
    }
};

RUBBLE_TEST(ImporterProblemsTest)
#include "ImporterProblemsTest.moc"
