out vec3 scenePoint;
flat out vec3 faceNormal;
flat out vec3 chipColour;  // linear
flat out float roughness;

const int kFlat = 1, kLong = 2;

// Irregular numbers in [-0.5, 0.5) of a corner of a form.
vec3 irregular(float seed, float corner) {
    return fract(vec3(17.31, 41.77, 89.13) * (seed + 0.137 * corner) + 0.31 * corner) - 0.5;
}
// Corners 0 to 2 are those of the base, 3 and 4 the tops.
vec3 cornerOf(int index, float seed) {
    const vec3 kCorners[5] = vec3[5](vec3(0.95, 0.0, 0.0), vec3(-0.5, 0.0, 0.8), vec3(-0.5, 0.0, -0.8),
                                     vec3(0.0, 0.75, 0.0), vec3(0.0, -0.75, 0.0));
    return kCorners[index] + 0.6 * irregular(seed, float(index));
}
vec3 extentsOf(int shape) {
    if (shape == kFlat) return vec3(1.0, 0.1, 0.9);
    return shape == kLong ? vec3(1.3, 0.13, 0.16) : vec3(1.0, 0.7, 0.85);
}
vec3 rotatedAbout(vec3 axis, float angle, vec3 v) {
    float c = cos(angle), s = sin(angle);
    return c * v + s * cross(axis, v) + (1.0 - c) * dot(axis, v) * axis;
}

void main() {
    const int kFaces[18] = int[18](0, 3, 1, 1, 3, 2, 2, 3, 0, 1, 4, 0, 2, 4, 1, 0, 4, 2);
    int number = gl_VertexID % 18, first = number - number % 3, shape = int(colour.w);
    float seed = fract(colour.w), angle = rotation.w + (1.0 - edges.w) * previousOffset.w;
    vec3 corners[3];
    for (int k = 0; k < 3; ++k) {
        vec3 corner = extentsOf(shape) * cornerOf(kFaces[first + k], seed);
        corner = rotatedAbout(vec3(0.0, 1.0, 0.0), 6.2831853 * fract(7.0 * seed), corner);
        corners[k] = rotatedAbout(rotation.xyz, angle, corner);
    }
    scenePoint = chipCentre() + centre.w * corners[number % 3];
    faceNormal = normalize(cross(corners[1] - corners[0], corners[2] - corners[0]));
    chipColour = linearOf(colour.rgb);
    roughness = shape == kFlat ? 0.12 : 0.9;
    gl_Position = clipFromScene * vec4(scenePoint, 1.0);
}
