packs/old\ roof/manifest.json: two.rubble
