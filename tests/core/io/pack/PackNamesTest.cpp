// Tests core/io/pack/PackExport.cpp and core/io/system/FileName.cpp.
#include "core/io/pack/PackExport.h"
#include "core/io/pack/PackFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileName.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/files/FolderNames.h"
#include "tests/support/files/NameRules.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace rubble;
namespace fs = std::filesystem;

namespace {

/// Names that some system refuses, reserves, changes or takes for one another.
std::vector<std::string> hostileNames() {
    return {// devices of Windows
            "CON", "con", "Nul", "com1", "COM1", "LPT1.txt", "lpt9", "aux.x", "AUX", "prn.obj", "CONIN$", "CONOUT$",
            "com²", "NUL .txt", "com0",
            // ends
            "dot.", "dot..", "space ", " space", ".hidden", "..", ".", "-", "--help", "tab\t",
            // characters that a system reserves
            "a<b>c", "a:b", "a\"b", "a|b", "a?b", "a*b", "a/b", "a\\b", "a_b", "line\nbreak", "bell\x07", "delete\x7f",
            // characters that nobody sees, or that turn the text around
            "next\xc2\x85line", "line\xe2\x80\xa8separator", "paragraph\xe2\x80\xa9separator", "\xe2\x80\xaetxt.exe",
            "zero\xe2\x80\x8bwidth", "zerowidth", "zero\xe2\x80\x8dwidth", "\xef\xbb\xbfmark", "mark",
            "soft\xc2\xadhyphen", "variation\xef\xb8\x8f",
            "no\xc2\xa0"
            "break",
            "no break",
            // case and normalization
            "Wall", "wall", "WALL", "wall-2", "Ä", "ä", "a\xcc\x88", "é", "e\xcc\x81",
            "STRASSE",                                                             // one in upper case
            "straße", "Straße", "ﬁre", "fire", "ı", "i", "İ", "ς", "σ", "Σ", "K",  // that of temperatures
            "\xe2\x84\xaa", "Å", "\xe2\x84\xab", "한글",
            "\xe1\x84\x92\xe1\x85\xa1\xe1\x86\xab\xe1\x84\x80\xe1\x85\xb3\xe1\x86\xaf",
            // other scripts and planes
            "日本語の壁", "😀",  // and private use, unassigned, long
            "\xf3\xb0\x80\x80", "\xf0\xb3\x8d\x90", std::string(300, 'x'), std::string(300, 'X'),
            // 100 characters of 2 bytes, of 3 UTF-16 units each in normalization form D
            [] {
                std::string name;
                for (int k = 0; k < 100; ++k) name += "ΐ";
                return name;
            }(),
            "pack.json", "manifest.json"};
}

Project projectWithAssets(const std::vector<std::string>& names) {
    Project project;
    project.materials = {{.id = 1, .name = "con"}};
    Id id = 10;
    for (const std::string& name : names) {
        Asset asset = assetOf(unitSquare(), 0.5);
        asset.id = ++id;
        asset.name = name;
        asset.material = 1;
        asset.pattern = scatterOf(2, 100 + id);
        project.assets.push_back(asset);
    }
    project.nextId = 1000;
    return project;
}

QStringList toQt(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names) list.append(QString::fromStdString(name));
    return list;
}

}  // namespace

class PackNamesTest : public QObject {
    Q_OBJECT
private slots:
    void rulesRefuseWhatSystemsRefuse() {
        for (const char* name : {"con", "aux.x", "a:b", "dot.", "space ", "a/b", "", ".", "bell\x07", "LPT1 .txt"}) {
            QVERIFY2(!test::brokenNameRules(name).isEmpty(), name);
        }
        for (const char* name : {"wall", "Süd", "console", "com10", ".x"}) {
            QVERIFY2(test::brokenNameRules(name).isEmpty(), name);
        }
        QVERIFY(!test::sameNames({"Ä", "ä"}).isEmpty() && !test::sameNames({"é", "e\u0301"}).isEmpty());
        QVERIFY(!test::sameNames({"STRASSE", "straße"}).isEmpty() && test::sameNames({"wall", "walls"}).isEmpty());
    }
    void foldersAndFilesAreValidAndDistinctEverywhere() {
        const std::vector<std::string> names = hostileNames();
        QVERIFY(names.size() >= 50);
        const QTemporaryDir temporary;
        const fs::path out = temporary.filePath("packs").toStdString();
        const Project project = projectWithAssets(names);
        std::vector<Id> ids;
        for (const Asset& asset : project.assets) ids.push_back(asset.id);
        const auto exported =
            exportPacks(project, ids, out, {.meshes = {.formats = {"obj"}, .split = FileSplit::PerFragment}});
        QVERIFY2(exported.hasValue(), exported ? "" : exported.error().message.c_str());
        for (std::size_t k = 0; k < names.size(); ++k) {
            const AssetExport& one = (*exported)[k];
            QVERIFY2(one.status.hasValue(), one.status ? "" : one.status.error().message.c_str());
            const Result<Pack> pack = readPack(readFile(one.folder / "pack.json").value());
            QVERIFY2(pack.hasValue(), pack ? "" : pack.error().message.c_str());
            QCOMPARE(pack->names.name, names[k]);
            checkNames(toQt(namesIn(one.folder)));
        }
        const QStringList folders = toQt(namesIn(out));
        QCOMPARE(folders.size(), qsizetype(names.size()));
        checkNames(folders);
    }
    void ordinaryNamesStayAsTheyAre() {
        const std::vector<std::string> names = {"Mauer Süd-2", "日本語の壁", "console", "v1.2", "σύνν"};
        QVERIFY(distinctFileNames(names) == names);
    }
    void theFirstKeepsItsName() {
        const std::vector<std::string> names = {"Wall", "wall", "wall-2", "WALL"};
        QCOMPARE(toQt(distinctFileNames(names)), (QStringList{"Wall", "wall-3", "wall-2", "WALL-4"}));
    }
    void variantsLeaveTheirNamesToAssets() {
        Project project = projectWithAssets({"wall", "wall_1"});
        project.instances = {{.id = 20, .name = "one", .asset = 11, .variant = 1}};
        const auto folders = packNames(project);
        QCOMPARE(folders.at({11, 0}).folder, std::string("wall"));
        QCOMPARE(folders.at({12, 0}).folder, std::string("wall_1"));
        QCOMPARE(folders.at({11, 1}).folder, std::string("wall_1-2"));
    }

private:
    static void checkNames(const QStringList& names) {
        for (const QString& name : names) {
            QVERIFY2(test::brokenNameRules(name).isEmpty(),
                     qPrintable(name + ": " + test::brokenNameRules(name).join("; ")));
        }
        QVERIFY2(test::sameNames(names).isEmpty(), qPrintable(test::sameNames(names).join(" and ")));
    }
};

RUBBLE_TEST(PackNamesTest)
#include "PackNamesTest.moc"
