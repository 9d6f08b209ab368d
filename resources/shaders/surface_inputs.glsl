// What the surface at a pixel gets from its vertices.
in vec3 scenePoint;
in vec3 sceneNormal;
in vec2 placeAcross;
in float edgeWidth;  // pixels, on each side of an edge
flat in vec3 colour;  // linear
flat in float opacity;
#ifdef TEXTURED
uniform sampler2D baseColour;
in vec2 placeInImage;
flat in float hasImage;
#endif
