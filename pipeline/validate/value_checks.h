// Rules between the properties of one object. Each function is called when the properties have passed the
// schema: what did not pass is gone from the object.
#pragma once

#include "pipeline/validate/schema_walk.h"

namespace barrido::scene::validation {

/// Nothing for types of objects that have no such rules.
void check_values(SchemaWalk& walk, ObjectType type, Json& object, const Place& place);

void check_material_values(SchemaWalk& walk, Json& material, const Place& place);
void check_mesh_values(SchemaWalk& walk, Json& mesh, const Place& place);
void check_primitive_values(SchemaWalk& walk, Json& primitive, const Place& place);
void check_node_values(SchemaWalk& walk, Json& node, const Place& place);
void note_texture_info(SchemaWalk& walk, Json& info, const Place& place);
void note_normal_texture_info(SchemaWalk& walk, Json& info, const Place& place);
void note_texture_transform(SchemaWalk& walk, Json& transform, const Place& place);
void check_light_values(SchemaWalk& walk, Json& light, const Place& place);
void check_spot_values(SchemaWalk& walk, Json& spot, const Place& place);
void check_iridescence_values(SchemaWalk& walk, Json& iridescence, const Place& place);

}  // namespace barrido::scene::validation
