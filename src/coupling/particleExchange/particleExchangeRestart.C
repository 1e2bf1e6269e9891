/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Restart of the pending kicks and of what laws remember, and averages of
// the particles

#include "particleExchange.H"
#include "OSspecific.H"
#include "particleRecord.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of a particle in the restart: momentum and heat
constexpr Foam::label nKickValues = 4;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::dew::particleExchange::restartFile
(
    const word& name
) const
{
    const Time& time = mesh_.time();
    return time.path()/time.timeName()/"uniform"/"particles"/name;
}


Foam::fileName Foam::dew::particleExchange::restartToRead
(
    const word& name
) const
{
    // Of the master's processor directory, or of the whole case, as the
    // engine's own restart
    const fileName path(restartFile(name));
    if (isFile(path))
    {
        return path;
    }
    const Time& time = mesh_.time();
    return
        time.globalPath()/time.timeName()/"uniform"/"particles"/name;
}


bool Foam::dew::particleExchange::readKicks()
{
    // Sources of a step that is over: nothing is pending but what was written
    const label n = state_.size();
    kick_.setSize(n);
    UList<vector>& kick = kick_;
    kick = Zero;
    if (heat_)
    {
        heatKick_.setSize(n);
        UList<scalar>& heatKick = heatKick_;
        heatKick = 0;
    }
    kicked_ = true;

    // A run of particles alone has none
    const Time& time = mesh_.time();
    const fileName path(restartToRead("exchange"));
    bool found = isFile(path);
    Pstream::scatter(found);
    if (!found)
    {
        // Averages are written with it
        bool lost =
            isFile(time.path()/time.timeName()/"U.particles")
         || isFile(time.path()/time.timeName()/"U.particles.gz");
        Pstream::scatter(lost);
        if (lost)
        {
            FatalErrorInFunction
                << "The restart of the exchange is incomplete: no file "
                << path << nl << "Start from an earlier time, or from the"
                << " beginning" << exit(FatalError);
        }
        return false;
    }

    boolList known;
    const List<scalar> values
    (
        particleRecord::read(path, state_.id, nKickValues, known)
    );
    forAll(known, i)
    {
        if (!known[i])
        {
            FatalErrorInFunction
                << "The restart of the exchange " << path
                << " does not know particle " << state_.id[i] << nl
                << "Start from an earlier time, or from the beginning"
                << exit(FatalError);
        }
    }
    for (label i = 0; i < n; i++)
    {
        const scalar* v = values.cdata() + nKickValues*i;
        kick_[i] = vector(v[0], v[1], v[2]);
        if (heat_)
        {
            heatKick_[i] = v[3];
        }
    }
    return true;
}


void Foam::dew::particleExchange::readMemory(const bool goesOn)
{
    const label n = state_.size(), nMemory = nLawMemory();
    memory_.setSize(needs().memory*n, scalar(0));
    lastForce_.setSize(needs().lastForce ? n : 0, vector::zero);

    for (scalarExchange& s : scalars_)
    {
        s.read(restartToRead("scalar." + s.name()), goesOn, memory_);
    }

    const label nValues = nMemory + (needs().lastForce ? 3 : 0);
    const fileName path(restartToRead("laws"));
    bool found = nValues && isFile(path);
    Pstream::scatter(found);
    if (!found)
    {
        if (nValues && goesOn)
        {
            Info<< "WARNING: no file " << path << ": what laws remember of the"
                << " particles (history, eddies, own disturbance) starts anew"
                << nl << endl;
        }
        return;
    }

    boolList known;
    const List<scalar> values
    (
        particleRecord::read(path, state_.id, nValues, known)
    );
    for (label i = 0; i < n; i++)
    {
        const scalar* v = values.cdata() + nValues*i;
        std::copy(v, v + nMemory, memory_.data() + needs().memory*i);
        if (needs().lastForce)
        {
            v += nMemory;
            lastForce_[i] = vector(v[0], v[1], v[2]);
        }
    }
}


void Foam::dew::particleExchange::writeMemory() const
{
    for (const scalarExchange& s : scalars_)
    {
        s.write(restartFile("scalar." + s.name()), memory());
    }

    const label nMemory = nLawMemory();
    const label nValues = nMemory + (needs().lastForce ? 3 : 0);
    if (!nValues)
    {
        return;
    }

    List<scalar> values(nValues*state_.size());
    for (label i = 0; i < state_.size(); i++)
    {
        scalar* v = values.data() + nValues*i;
        const scalar* m = memory().cdata() + needs().memory*i;
        v = std::copy(m, m + nMemory, v);
        for (direction k = 0; needs().lastForce && k < 3; k++)
        {
            v[k] = lastForce_[i][k];
        }
    }
    particleRecord::write(restartFile("laws"), state_.id, values, nValues);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::particleExchange::writeObject
(
    IOstream::streamFormat fmt,
    IOstream::versionNumber ver,
    IOstream::compressionType cmp,
    const bool valid
) const
{
    updateKicks();

    const label n = state_.size();
    List<scalar> values(nKickValues*n, scalar(0));
    for (label i = 0; i < n; i++)
    {
        scalar* v = values.data() + nKickValues*i;
        for (direction k = 0; k < 3; k++)
        {
            v[k] = kick_[i][k];
        }
        if (heat_)
        {
            v[3] = heatKick_[i];
        }
    }
    const fileName path(restartFile("exchange"));
    if (Pstream::master())
    {
        mkDir(path.path());
    }
    particleRecord::write(path, state_.id, values, nKickValues);
    writeMemory();

    // Averages of the particles in each cell, by mass
    scalarField solid(mesh_.nCells(), Zero);
    volVectorField Up
    (
        IOobject("U.particles", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false),
        mesh_,
        dimensionedVector(dimVelocity, Zero),
        "zeroGradient"
    );
    List<scalar> mass(n);
    List<vector> flow(n);
    for (label i = 0; i < n; i++)
    {
        mass[i] = state_.mass(i);
        flow[i] = mass[i]*state_.v[i];
    }
    map_.scatter(mass, solid);
    map_.scatter(flow, Up.primitiveFieldRef());
    forAll(solid, celli)
    {
        if (solid[celli] > 0)
        {
            Up[celli] /= solid[celli];
        }
    }
    Up.correctBoundaryConditions();

    return Up.writeObject(fmt, ver, cmp, valid);
}
