#include "core/fracture/sampling/SolidDomain.h"

namespace rubble {

Result<SolidDomain> SolidDomain::of(TriangleMesh mesh, const TaskContext& task) {
    Result<SolidSurface> surface = SolidSurface::of(std::move(mesh));
    if (!surface) return surface.error();
    Result<SolidScatter> uniform = SolidScatter::of(*surface, {}, task);
    if (!uniform) return uniform.error();
    if (uniform->isEmpty()) return Error{ErrorCode::Degenerate, "The mesh is too thin: it encloses no volume."};
    return SolidDomain(*surface, std::make_shared<const SolidScatter>(std::move(*uniform)));
}

}  // namespace rubble
