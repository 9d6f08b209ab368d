out vec3 scenePoint;

void main() {
    scenePoint = vec3((gl_VertexID & 1) != 0 ? shaded.z : shaded.x, ground.y,
                      (gl_VertexID & 2) != 0 ? shaded.w : shaded.y);
    gl_Position = clipFromScene * vec4(scenePoint, 1.0);
}
