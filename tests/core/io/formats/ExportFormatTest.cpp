// Tests core/io/formats/ExportFormat.cpp and the rows of all formats: core/io/formats/ObjFormat.cpp,
// core/io/formats/GlbFormat.cpp, core/io/formats/MjcfFormat.cpp, core/io/formats/UsdFormat.cpp.
#include "core/io/formats/ExportFormat.h"

#include "core/asset/bake/Bake.h"
#include "core/io/formats/ExportTarget.h"
#include "core/io/pack/PackExport.h"
#include "core/io/pack/PackMeshes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/FileBytes.h"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <set>

using namespace rubble;

namespace {

Project brickProject() { return boxProject(UniformScatter{.count = 5}); }

ContentHash sourceOf(const PackOptions& options) {
    const Project project = brickProject();
    const PackNames names = packNames(project, options).begin()->second;
    return packSourceHash(project, project.assets[0], names, options);
}

/// The files of formats of a box in fragments.
std::vector<ExportFile> filesOfBox(std::uint32_t fragments, const MeshOptions& options) {
    const Asset asset = boxAsset(2, 3, UniformScatter{.count = fragments});
    const Material stone{.id = 1, .name = "stone", .density = 2000.0};
    const Bake baked = bake(asset).value();
    const PackBuilder pack({baked, asset, {stone, stone}, packNames(asset), {}});
    return packMeshes(pack, options).value().files;
}

bool hasOption(const ExportFormat& format, const ExportOption* option) {
    return std::ranges::find(format.options, option) != format.options.end();
}

}  // namespace

class ExportFormatTest : public QObject {
    Q_OBJECT
private slots:
    void rowsAreComplete() {
        std::set<std::string_view> words;
        for (const ExportFormat* format : exportFormats()) {
            words.insert(format->word);
            QCOMPARE(formatNamed(format->word), format);
            QVERIFY(!format->caption.empty() && format->hint.starts_with("Write "));
            QVERIFY(format->bytesPerFragment({}) > 0.0);
            QVERIFY(format->suffix.empty() == (format->partFile == nullptr));
            QVERIFY((format->assetFileNames == nullptr) == (format->assetFiles == nullptr));
            QVERIFY(format->partFile != nullptr || format->assetFiles != nullptr);
        }
        QCOMPARE(words.size(), exportFormats().size());
        QVERIFY(formatNamed("stone") == nullptr);
    }
    /// While it is exported, a fragment takes about what the files hold of it.
    void memoryOfAFragmentIsThatOfItsFiles() {
        for (const ExportFormat* format : exportFormats()) {
            for (const GlbKind kind : {GlbKind::Plain, GlbKind::Physics, GlbKind::Compact, GlbKind::Named}) {
                const MeshOptions options{.formats = {format->word}, .glbKind = kind};
                double bytes = 0.0;
                for (const ExportFile& file : filesOfBox(100, options)) bytes += static_cast<double>(file.bytes.size());
                const double ratio = 100.0 * meshBytesPerFragment(options) / bytes;
                QVERIFY2(ratio > 0.8 && ratio < 5.0, format->word.data());
            }
        }
    }
    void unbrokenFragmentsAreThoseOfTheDeepestLevels() {
        Asset asset = boxAsset(2, 3, UniformScatter{.count = 5});
        asset.levels = {{.pattern = asset.pattern}};
        const Bake baked = bake(asset).value();
        QCOMPARE(baked.fractures.size(), std::size_t{6});
        std::vector<std::uint32_t> expected(baked.fragmentCount() - 5);
        std::iota(expected.begin(), expected.end(), 5u);  // the first five break
        QCOMPARE(unbrokenFragments(baked), expected);
    }
    void facesOfObjFilesAreAsSelected() {
        for (const FaceShape faces : {FaceShape::Polygons, FaceShape::Triangles}) {
            qsizetype most = 0;
            for (const ExportFile& file : filesOfBox(5, {.formats = {"obj"}, .faces = faces})) {
                for (const QByteArray& line : QByteArray::fromStdString(file.bytes).split('\n'))
                    if (line.startsWith("f ")) most = std::max(most, line.count(' '));
            }
            QVERIFY2(faces == FaceShape::Triangles ? most == 3 : most > 3, QByteArray::number(most));
        }
    }
    void setsKeepTheOrderOfTheFiles() {
        const std::vector<const ExportFormat*> formats = formatsOf({"usd", "glb", "stone", "obj"});
        QCOMPARE(formats.size(), std::size_t{3});
        QVERIFY(formats[0]->word == "obj" && formats[1]->word == "glb" && formats[2]->word == "usd");
    }
    /// An existing export is written again if, and only if, what its formats have changed.
    void sourcesCoverTheOptionsOfTheirFormats() {
        for (const ExportFormat* format : exportFormats()) {
            PackOptions before;
            before.meshes.formats = {format->word};
            for (const ExportOption* option : exportOptions()) {
                PackOptions after = before;
                option->set(after, option->get(after) == 0 ? 1 : 0);
                const bool isOfPacks = option->caption.empty();
                const bool isNoticed = sourceOf(after) != sourceOf(before);
                QVERIFY2(isNoticed == (isOfPacks || hasOption(*format, option)), option->word.data());
            }
            QVERIFY(sourceOf({.meshes = {.formats = {}}}) != sourceOf(before));
        }
    }
    void theManualPageNamesAllWords() {
        const QByteArray page = bytesOfFile(RUBBLE_SOURCE_DIR "/resources/linux/rubble-cli.1").replace("\\-", "-");
        const auto isNamed = [&](std::string_view word) { return page.contains(QByteArray(word.data())); };
        for (const ExportFormat* format : exportFormats()) QVERIFY2(isNamed(format->word), format->word.data());
        for (const ExportTarget& target : exportTargets()) QVERIFY2(isNamed(target.word), target.word.data());
        for (const ExportOption* option : exportOptions()) {
            QVERIFY2(page.contains("--" + QByteArray(option->word.data())), option->word.data());
            for (const ExportOption::Value& value : option->values) QVERIFY2(isNamed(value.word), value.word.data());
        }
    }
    void theManualNamesAllFormatsAndPrograms() {
        const QString page = bytesOfFile(RUBBLE_SOURCE_DIR "/docs/manual/export.md");
        for (const ExportFormat* format : exportFormats()) {
            const QString name = QString(format->caption.data()).remove('&').section(' ', 0, 0);
            QVERIFY2(page.contains("**" + name + "**"), format->caption.data());
        }
        for (const ExportTarget& target : exportTargets())
            QVERIFY2(page.contains(target.title.data(), Qt::CaseInsensitive), target.title.data());
    }
};

RUBBLE_TEST(ExportFormatTest)
#include "ExportFormatTest.moc"
