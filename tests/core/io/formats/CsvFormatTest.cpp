#include "core/asset/bake/Bake.h"
#include "core/io/formats/ExportFormat.h"
#include "core/io/pack/PackMeshes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QStringList>
#include <QTest>

#include <cmath>

using namespace rubble;

class CsvFormatTest : public QObject {
    Q_OBJECT
private slots:
    void rowsAreThoseOfThePack() {
        const Asset asset = boxAsset(2, 3, UniformScatter{.count = 7});
        const Material stone{.id = 1, .name = "stone", .density = 2000.0};
        const Result<Bake> baked = bake(asset);
        const PackBuilder pack({*baked, asset, {stone, stone}, packNames(asset), {}});
        const Result<PackMeshes> meshes = packMeshes(pack, {.formats = {"csv"}});
        QVERIFY(meshes && meshes->list.empty());
        QCOMPARE(meshes->files.size(), std::size_t{1});
        QCOMPARE(meshes->files[0].name, std::string("box.csv"));
        const QStringList rows = QString::fromStdString(meshes->files[0].bytes).split('\n', Qt::SkipEmptyParts);
        QCOMPARE(rows.size(), qsizetype(1 + 1 + baked->fragmentCount()));
        QVERIFY(rows[0].startsWith("id,name,parent,level,mass,volume,centre[0]"));
        double mass = 0.0;
        for (qsizetype k = 2; k < rows.size(); ++k) {
            const QStringList fields = rows[k].split(',');
            const PackBody body = pack.fragment(static_cast<std::uint32_t>(k - 2));
            QCOMPARE(fields[1], QString::fromStdString(body.name));
            QCOMPARE(fields[2], QString("2"));
            QCOMPARE(fields[6].toDouble(), body.offset.x + body.centreOfMass.x);
            mass += fields[4].toDouble();
        }
        QVERIFY(std::abs(mass - 1000.0) < 1e-9);  // 1 x 1 x 0.5 m
        QCOMPARE(rows[1].split(',')[4].toDouble(), 1000.0);
    }
    void centreOfTheWholeIsThatOfItsMass() {
        Asset asset = boxAsset(2, 3, UniformScatter{.count = 7});
        asset.prism().outline.outer = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
        const Material stone{.id = 1, .name = "stone", .density = 2000.0};
        const Bake baked = bake(asset).value();
        const PackBuilder pack({baked, asset, {stone, stone}, packNames(asset), {}});
        const std::string table = packMeshes(pack, {.formats = {"csv"}}).value().files[0].bytes;
        const QStringList fields = QString::fromStdString(table).split('\n')[1].split(',');
        QVERIFY2(std::abs(fields[6].toDouble() - 1.0 / 3.0) < 1e-9, qPrintable(fields[6]));
    }
};

RUBBLE_TEST(CsvFormatTest)
#include "CsvFormatTest.moc"
