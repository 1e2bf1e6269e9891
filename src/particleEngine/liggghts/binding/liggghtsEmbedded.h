/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::liggghtsEmbedded

Description
    The embedded engine behind liggghtsBinding.H: LIGGGHTS on a duplicate of
    all ranks, in its own units.

SourceFiles
    liggghtsEmbedded.cpp
    liggghtsAddition.cpp
    liggghtsExchange.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_liggghtsEmbedded_h
#define dew_liggghtsEmbedded_h

#include "liggghtsBinding.H"
#include "engineErrors.h"
#include "fixIntegrate.h"

#include <cfenv>

#include "atom.h"
#include "lammps.h"
#include "universe.h"
#include "update.h"

namespace Foam
{
namespace dew
{

class fixColloidPairs;

//- Floating-point traps belong to the host: inside the engine a NaN must be
//  reported with its particle, not end in a signal
class trapsOff
{
    int mask_;

public:

    trapsOff() : mask_(fedisableexcept(FE_ALL_EXCEPT)) {}

    ~trapsOff()
    {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(mask_);
    }
};


class liggghtsEmbedded
:
    public liggghtsBinding
{
    bool ownMpi_;
    MPI_Comm world_;
    LAMMPS_NS::LAMMPS* lmp_;
    engineUnits units_;
    double viscosity_;
    fixIntegrate* integrate_;
    fixColloidPairs* colloids_;

    //- Width of neighbour bins given to the engine, 0: its own [its units]
    double binSize_;

    //- Do forces belong to the present particles?
    bool forcesValid_;

    //- The integrator, made by the command "fix ... dew/integrate"
    fixIntegrate& integrator();

    bool outsideBox() const;

    //- Bins wide enough to be no more than some hundred a particle, where the
    //  engine would fill the box with bins of half a cutoff
    void limitBins();

    //- Refuse a particle that drag does not hold
    void checkDrag(const bulkForcesView&) const;

    //- Coefficient of a film's drainage from the viscosity in its column
    void setDrainage(int i, double share);

    //- Noise and surface of the coming sub-steps
    void pushColloids(const bulkForcesView&);

    //- Momentum and heat given at once
    void give(const double* kick, const double* heatKick);

    //- Integral of gravity over the time since push(), engine units
    void gravityImpulse(double* perMass) const;

    //- Sensitivities of what was received, SI
    void sensitivities(double* impulseSp, double* heatSp) const;

public:

    explicit liggghtsEmbedded(const liggghtsOptions&);

    ~liggghtsEmbedded() override;

    std::string version() const override { return lmp_->universe->version; }

    void command(const std::string&) override;
    void units(const engineUnits& u) override { units_ = u; }
    void expect(double maxRadius, bool heat) override;
    void dynamics(unsigned long seed, double viscosity) override;
    void hinderingWalls
    (
        const std::vector<double>& planes, double minGap
    ) override;
    double deltaT() const override { return lmp_->update->dt*units_.time; }
    void gravity(std::function<void(double, double*)>) override;
    void colloids(const pairInteraction&) override;
    double colloidEnergy() const override;
    long add(const newParticles&) override;
    void overlapping
    (
        const newParticles&, double share, std::vector<char>& hit
    ) const override;
    void setup() override;
    void push(const bulkForcesView&) override;
    void run(long nSteps) override;
    int size() const override { return lmp_->atom->nlocal; }
    void pull(const stateView&) const override;
    void contacts(const contactView&) override;
    std::vector<departedParticle> departed() override;
    double wallHeat() const override;
    long step() const override { return long(lmp_->update->ntimestep); }
    long total() const override;
    void writeRestart(const std::string& file) override;
    std::vector<std::string> warnings() override { return engineWarnings(); }
};

} // End namespace dew
} // End namespace Foam

#endif
