/// @file
/// A simulator of the least policies that the concepts accept. It compiles as it stands, so the
/// concepts ask for all that the simulator uses; with any faulty policy in its place it must not.
#include <hfdem/simulator.hpp>
#ifdef FLUID
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>
#endif

#include "models.hpp"

#ifndef CONTACT
#define CONTACT Law
#endif
#ifndef APERTURE
#define APERTURE Aperture
#endif
#ifndef PRESSURE
#define PRESSURE Scheme
#endif
#ifndef NEIGHBOURS
#define NEIGHBOURS Search
#endif

using namespace models;
#ifdef FLUID
template class hfdem::Simulator<CONTACT, APERTURE, hfdem::ImplicitFlow<FLUID>, NEIGHBOURS>;
template class hfdem::Simulator<CONTACT, APERTURE, hfdem::ConventionalFlow<FLUID>, NEIGHBOURS>;
#elif defined(JOINT)
template class hfdem::Simulator<hfdem::Jointed<CONTACT, JOINT>, APERTURE, PRESSURE, NEIGHBOURS>;
#else
template class hfdem::Simulator<CONTACT, APERTURE, PRESSURE, NEIGHBOURS>;
#endif
