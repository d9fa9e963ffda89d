"""A rock of bonded discs in Yade: what a contact costs in a step. Run by compare.py, as

    PYTHONPATH=benchmarks/peers yade -n -x benchmarks/peers/yade_rock.py SPECIMEN LAW STEPS

SPECIMEN is a file of hfdem's, LAW cohfrict (bonds with moments: CohesionMoment) or jcfpm (bonds
without: JointedCohesiveFrictionalPM). Discs are spheres that stay in their plane; all bonds hold.
"""

import json
import sys
import time

import rock_file

from yade import *  # noqa: F403  (how a script of Yade's begins)

path, law, steps = sys.argv[1], sys.argv[2], int(sys.argv[3])
header, discs = rock_file.read(path)
mean_radius = sum(radius for _, _, radius in discs) / len(discs)
reach = 1 + header["bonding_gap"] / (2 * mean_radius)
common = {"young": 17e9, "poisson": 0.4, "frictionAngle": 0.46, "density": header["density"]}
if law == "cohfrict":
    material = CohFrictMat(isCohesive=True, normalCohesion=1e12, shearCohesion=1e12,
                           momentRotationLaw=True, **common)
    loop = InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom6D(interactionDetectionFactor=reach)],
        [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)],
        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()])
else:
    material = JCFpmMat(tensileStrength=1e12, cohesion=1e12, **common)
    loop = InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(interactionDetectionFactor=reach)],
        [Ip2_JCFpmMat_JCFpmMat_JCFpmPhys(cohesiveTresholdIteration=1)],
        [Law2_ScGeom_JCFpmPhys_JointedCohesiveFrictionalPM()])
material = O.materials.append(material)
for x, y, radius in discs:
    body = sphere((x, y, 0), radius, material=material)
    body.state.blockedDOFs = "zXY"
    O.bodies.append(body)
# Neighbours are searched once: nothing moves so far.
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=reach)],
                          verletDist=0.2 * mean_radius),
    loop,
    NewtonIntegrator(damping=0.7),
]
O.dt = 0.3 * PWaveTimeStep()
O.run(5, True)
begun = time.perf_counter()
O.run(steps, True)
seconds = time.perf_counter() - begun
contacts = O.interactions.countReal()
print("\nRESULT " + json.dumps({"contacts": contacts,
                              "ns_per_contact_step": 1e9 * seconds / (steps * contacts)}))
