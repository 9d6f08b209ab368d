out vec3 scenePoint;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    scenePoint = ground.xyz + ground.w * vec3(corner.x, 0.0, corner.y);
    gl_Position = clipFromScene * vec4(scenePoint, 1.0);
}
