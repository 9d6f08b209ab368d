# What programs/Measure.h does for engines in C++, for Godot 3: PACK whole|leaves stands|lies MARGIN.
extends SceneTree

const STEP = 1.0 / 60.0

var arguments = []


func _init():
	var all = OS.get_cmdline_args()
	arguments = Array(all).slice(all.size() - 4, all.size() - 1)
	call_deferred("measure")


func vector(v):
	return Vector3(v[0], v[1], v[2])


func placed():
	var file = File.new()
	file.open(arguments[0], File.READ)
	var pack = JSON.parse(file.get_as_text()).result
	var parents = {}
	for fragment in pack.fragments:
		if fragment.parent != null:
			parents[int(fragment.parent)] = true
	var bodies = []
	for k in range(pack.fragments.size()):
		var fragment = pack.fragments[k]
		if parents.has(k) if arguments[1] == "leaves" else fragment.parent != null:
			continue
		var basis = Basis(Vector3(1, 0, 0), -PI / 2) if arguments[2] == "lies" else Basis()
		bodies.append({"fragment": fragment, "at": Transform(basis, basis.xform(vector(fragment.offset)))})
	return [pack, bodies]


# The adapter. Godot 3 computes inertia from the shape itself.
func add(scene, body, material):
	var added = RigidBody.new()
	added.mass = body.fragment.mass
	added.linear_damp = 0
	added.angular_damp = 0
	added.physics_material_override = PhysicsMaterial.new()
	added.physics_material_override.friction = material.friction
	added.physics_material_override.bounce = material.restitution
	for hull in body.fragment.hulls:
		var points = PoolVector3Array()
		for vertex in hull.vertices:
			points.append(vector(vertex))
		var shape = ConvexPolygonShape.new()
		shape.points = points
		shape.margin = float(arguments[3])
		var collision = CollisionShape.new()
		collision.shape = shape
		added.add_child(collision)
	added.transform = body.at
	scene.add_child(added)
	return added


func add_floor(scene, bodies, friction):
	var lowest = INF
	for body in bodies:
		for hull in body.fragment.hulls:
			for vertex in hull.vertices:
				lowest = min(lowest, body.at.xform(vector(vertex)).y)
	var floor_body = StaticBody.new()
	floor_body.physics_material_override = PhysicsMaterial.new()
	floor_body.physics_material_override.friction = friction
	var collision = CollisionShape.new()
	collision.shape = BoxShape.new()
	collision.shape.extents = Vector3(10, 1, 10)
	floor_body.add_child(collision)
	floor_body.translation = Vector3(0, lowest - 1, 0)
	scene.add_child(floor_body)


func farthest(bodies, from):
	var most = 0.0
	for k in range(bodies.size()):
		most = max(most, bodies[k].translation.distance_to(from[k]))
	return most


func positions(bodies):
	var all = []
	for body in bodies:
		all.append(body.translation)
	return all


func measure():
	var read = placed()
	var material = read[0].material if read[0].version == 1 else read[0].materials[read[0].material]
	var space = root.world.space
	PhysicsServer.area_set_param(space, PhysicsServer.AREA_PARAM_GRAVITY, 0)
	var results = []
	for has_floor in [false, true]:
		PhysicsServer.area_set_param(space, PhysicsServer.AREA_PARAM_GRAVITY, 9.81 if has_floor else 0.0)
		var scene = Spatial.new()
		root.add_child(scene)
		if has_floor:
			add_floor(scene, read[1], material.friction)
		var bodies = []
		for body in read[1]:
			bodies.append(add(scene, body, material))
		var start = positions(bodies)
		var halfway = []
		if not has_floor:
			var found = []
			for body in bodies:
				var at = body.translation
				found.append({"mass": body.mass, "friction": body.physics_material_override.friction,
						"position": [at.x, at.y, at.z]})
			results.append(found)
		yield(self, "physics_frame")  # the first step comes after it
		for step in range(300 if has_floor else 1):
			yield(self, "physics_frame")
			if step == 150:
				halfway = positions(bodies)
		if not has_floor:
			var fastest = farthest(bodies, start) / STEP
			for body in bodies:
				fastest = max(fastest, body.linear_velocity.length())
			results.append(fastest)
		else:
			results.append(farthest(bodies, start))
			results.append(farthest(bodies, halfway))
		scene.free()
	print(JSON.print({"found": results[0], "swap": results[1], "standing": results[2], "drift": results[3]}))
	quit()
