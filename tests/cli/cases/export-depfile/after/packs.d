packs/old_roof/manifest.json: two.rubble
