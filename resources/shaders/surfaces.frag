// The normals of the nearest solid surfaces.
in vec3 sceneNormal;
out vec4 pixel;

void main() { pixel = vec4(0.5 * normalize(sceneNormal) + 0.5, 1.0); }
